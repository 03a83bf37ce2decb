(* Rule Ties by its text: probabilities from labels and states alone, and of a goal by going through all runs. *)

open Scc_exact
open Scc_calculus
open Scc_semantics

let whole (s : State.t) leaf = Array.to_list s.processes |> List.find (fun p -> State.has_leaf p leaf)

let who (s : State.t) (label : Transition.label) =
  let leaves =
    match label with
    | Bounce { firsts; _ } -> firsts
    | Absorb { first; absorber } -> [ first; absorber ]
    | _ -> List.concat_map (fun (b : State.bond) -> [ b.one.at; b.two.at ]) (Transition.bonds label)
  in
  List.sort_uniq Int.compare (List.map (fun l -> (whole s l).leaves.(0).leaf) leaves)

let what k (t : Transition.t) =
  match t.label with
  | Bind b | Close b ->
    let after at = (State.leaf_of (whole t.target at) at).behaviour in
    (b.name, [ b.one.at; b.two.at ], [ after b.one.at; after b.two.at ])
  | _ -> ("", [ -1 - k ], [])

let same_what (a, b, c) (a', b', c') = a = a' && b = b' && List.equal Behaviour.equal_aged c c'

let classes equal list =
  let add found x = if List.exists (equal x) found then found else x :: found in
  List.length (List.fold_left add [] list)

let by_the_text s transitions =
  let urgent = List.filter (fun (t : Transition.t) -> Transition.is_urgent t.label) transitions in
  let all = List.mapi (fun k (t : Transition.t) -> (t, who s t.label, what k t)) urgent in
  let chance (_, w, x) =
    let mine = List.filter (fun (_, w', _) -> w = w') all in
    let alike = List.filter (fun (_, _, x') -> same_what x x') mine in
    let doings = classes same_what (List.map (fun (_, _, x) -> x) mine) in
    Rat.make Z.one (Z.of_int (classes ( = ) (List.map (fun (_, w, _) -> w) all) * doings * List.length alike))
  in
  List.map (fun ((t, _, _) as one) -> (t, chance one)) all

exception Beyond

module States = Hashtbl.Make (struct
    type t = State.t * Rat.t

    let equal (s, t) (s', t') = Rat.equal t t' && State.equal s s'
    let hash (s, t) = State.hash s + Rat.hash t
  end)

(* The probability to come to the goal until a time, where nothing is free and no state of an instant recurs. *)
let probability semantics initial ~until goal =
  let known = States.create 256 and on_the_way = States.create 16 in
  let rec from s time =
    if goal s then Rat.one
    else
      match States.find_opt known (s, time) with
      | Some p -> p
      | None ->
        if States.mem on_the_way (s, time) || States.length known > 3000 then raise Beyond;
        States.add on_the_way (s, time) ();
        let p = by (Result.get_ok (Network.successors semantics s)) s time in
        States.remove on_the_way (s, time);
        States.add known (s, time) p;
        p
  and by transitions s time =
    let branches =
      match transitions with
      | ({ label = Draw _ | Lot _; _ } : Transition.t) :: _ ->
        List.map (fun (t : Transition.t) -> (t, Transition.chance t.label)) transitions
      | ts -> (
          match by_the_text s ts with
          | [] -> List.map (fun t -> (t, Rat.one)) ts
          | urgent -> urgent)
    in
    let add sum ((t : Transition.t), chance) =
      let later = Rat.add time (Transition.duration t) in
      if Rat.compare later until > 0 then sum else Rat.add sum (Rat.mul chance (from t.target later))
    in
    List.fold_left add Rat.zero branches
  in
  from initial Rat.zero

