type t = { equalities : Constraint.t list; inequalities : Constraint.t list; simplex : Simplex.t }

let constraints t = t.equalities @ t.inequalities

let is_equality (c : Constraint.t) = c.relation = Equal
let may_be_tight (c : Constraint.t) = c.relation = At_most

(* The inequalities that hold with equality everywhere. Mostly there are none, which one system shows. *)
let implicit simplex constraints =
  let candidates = List.filter may_be_tight constraints in
  let all_strict t = List.fold_left (fun t c -> Option.bind t (fun t -> Simplex.add t (Constraint.strict c))) t in
  if all_strict (Some simplex) candidates <> None then []
  else List.filter (fun c -> Simplex.add simplex (Constraint.strict c) = None) candidates

(* Of those with one normal, which stand together, the first, which is the tightest. *)
let first_of_each constraints =
  let add found c =
    match found with last :: _ when Constraint.same_normal last c -> found | _ -> c :: found
  in
  List.rev (List.fold_left add [] constraints)

let sound what = function
  | Some x -> x
  | None -> Scc_base.Bug.fail __POS__ what

let irredundant simplex ~from inequalities =
  let judge (simplex, number, kept) c =
    if Simplex.is_redundant simplex number then (Simplex.without simplex number, number + 1, kept)
    else (simplex, number + 1, c :: kept)
  in
  let simplex, _, kept = List.fold_left judge (simplex, from, []) inequalities in
  (simplex, List.rev kept)

let make simplex all =
  let equalities, inequalities = List.partition is_equality all in
  let found = implicit simplex inequalities in
  let echelon = sound "no solution" (Echelon.of_list (equalities @ List.map Constraint.tight found)) in
  let equalities = Echelon.to_list echelon in
  let inequalities =
    List.map (Echelon.reduce echelon) inequalities
    |> List.filter (fun c -> Constraint.truth c = None)
    |> List.sort_uniq Constraint.compare
    |> first_of_each
  in
  let dimension = Simplex.dimension simplex in
  let simplex = sound "no solution" (Simplex.of_constraints dimension (equalities @ inequalities)) in
  let simplex, inequalities = irredundant simplex ~from:(List.length equalities) inequalities in
  { equalities; inequalities; simplex }
