open Scc_exact
open Scc_polyhedra
open Scc_calculus
open Scc_semantics
open Scc_state_sets

type t = Zone.t

(* Equalities in echelon form give some variables by the others, which get new numbers. *)
let thin (z : t) set =
  let n = Polyhedron.dimension set in
  let equalities = Polyhedron.equalities set in
  let given = List.filter_map Constraint.first_variable equalities in
  let free = List.filter (fun i -> not (List.mem i given)) (List.init n Fun.id) in
  let m = List.length free in
  let forms = Array.make n (Linear.constant m Rat.zero) in
  List.iteri (fun k i -> forms.(i) <- Linear.variable m k) free;
  let solve c =
    let f = Constraint.to_form c in
    let i = Option.get (Constraint.first_variable c) in
    let others = List.filter (fun j -> j <> i) (List.init n Fun.id) in
    let a = Linear.coefficient f i in
    let add sum j = Linear.sub sum (Linear.scale (Rat.div (Linear.coefficient f j) a) forms.(j)) in
    let start = Linear.constant m (Rat.neg (Rat.div f.constant a)) in
    forms.(i) <- List.fold_left add start others
  in
  List.iter solve equalities;
  Zone.with_variables z ~dimension:m forms (Polyhedron.minimal (Polyhedron.preimage set ~dimension:m forms))

let on z set = if Polyhedron.is_empty set then None else Some (thin z set)

let of_location m (l : Invariant.location) = thin (Invariant.zone m l) l.set

let points set =
  match Polyhedron.interior_point set with
  | None -> []
  | Some middle ->
    let beside i =
      let rec go step =
        let p = Array.mapi (fun j x -> if i = j then Rat.add x step else x) middle in
        if Polyhedron.mem set p then p else go (Rat.mul Rat.half step)
      in
      go Rat.one
    in
    middle :: List.init (Polyhedron.dimension set) beside

let tidied (definitions : Behaviour.definitions) (b : Behaviour.aged) =
  (* A name that stands for itself alone has no summands but itself (reading I-14). *)
  let rec summands depth = function
    | Behaviour.Sum (x, y) -> summands depth x @ summands depth y
    | Nil -> []
    | Call k when depth > 0 -> summands (depth - 1) definitions.(k).body
    | other -> [ other ]
  in
  match List.sort_uniq Behaviour.compare (summands (Array.length definitions) b.term) with
  | [] -> Behaviour.aged b.origin Behaviour.nil
  | x :: rest -> Behaviour.aged b.origin (List.fold_left Behaviour.sum x rest)

let map_leaves f s = State.mapi (fun _ -> State.map_leaves f) s

let tidy definitions (s : State.t) =
  let leaf (l : State.leaf) = { l with State.behaviour = tidied definitions l.behaviour } in
  map_leaves leaf (State.at ~step:s.step ~time:None s)

let state (m : Model.t) (z : t) point =
  let values = Zone.values z point in
  let definitions = (Fixed.model m values).definitions and fixed = Fixed.behaviour m values in
  let leaf (l : State.leaf) =
    let known = Behaviour.aged l.behaviour.origin (fixed l.behaviour.term) in
    { l with State.behaviour = Behaviours.pass definitions (Linear.eval z.ages.(l.leaf) point) known }
  in
  map_leaves leaf (Zone.at z point)
