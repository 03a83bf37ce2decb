(* Each equality with its first variable, by increasing variables. *)
type t = (int * Constraint.t) list

let empty = []
let reduce t c = List.fold_left (fun c (i, by) -> Constraint.eliminate c i ~by) c t

let rec insert (i, c) = function
  | ((j : int), d) :: rest when j < i -> (j, d) :: insert (i, c) rest
  | rest -> (i, c) :: rest

let add t (c : Constraint.t) =
  if c.relation <> Equal then Scc_base.Bug.fail __POS__ "not an equality";
  let c = reduce t c in
  match Constraint.first_variable c with
  | Some i -> Some (insert (i, c) (List.map (fun (j, d) -> (j, Constraint.eliminate d i ~by:c)) t))
  | None -> if Constraint.truth c = Some true then Some t else None

let of_list = List.fold_left (fun t c -> Option.bind t (fun t -> add t c)) (Some empty)
let to_list = List.map snd
