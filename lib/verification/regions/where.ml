open Scc_exact
open Scc_polyhedra
open Scc_calculus

type t = { ranges : Ranges.t; holds : Union.t; fails : Union.t; unknown : Union.t }

(* {1 Pieces} *)

let order pieces =
  let key p = (Polyhedron.affine_dimension p, Option.get (Polyhedron.interior_point p), p) in
  let compare (m, a, _) (n, b, _) = if m <> n then Int.compare n m else Scc_data.Arrays.compare Rat.compare a b in
  List.map (fun (_, _, p) -> p) (List.sort compare (List.map key pieces))

let with_pieces u change = Union.of_polyhedra (Union.dimension u) (change (Union.pieces u))

(* What is cut where pieces overlap should be the smaller ones: those of a smaller dimension at least. Disjoint
   pieces stay disjoint when two of them become one. *)
let tidy u =
  let greatest_first p q = Int.compare (Polyhedron.affine_dimension q) (Polyhedron.affine_dimension p) in
  let sorted = with_pieces (Union.merged u) (List.stable_sort greatest_first) in
  with_pieces (Union.merged (Union.disjoint sorted)) order

let overlap u v =
  List.exists (fun p -> List.exists (fun q -> not (Polyhedron.disjoint p q)) (Union.pieces v)) (Union.pieces u)

(* {1 Making} *)

let box ranges =
  let point (r : Ranges.range) = Rat.compare r.low.value r.high.value >= 0 in
  if Array.exists point ranges then Scc_base.Bug.fail __POS__ "a range without width";
  Union.of_polyhedron (Ranges.box ranges)

let make ranges ~holds ~fails =
  let box = box ranges in
  let holds = tidy (Union.inter box holds) and fails = tidy (Union.inter box fails) in
  if overlap holds fails then Scc_base.Bug.fail __POS__ "it holds and fails";
  { ranges; holds; fails; unknown = tidy (Union.difference (Union.difference box holds) fails) }

(* {1 What it says} *)

let measure u =
  match Volume.sum (List.map Volume.of_polyhedron (Union.pieces u)) with
  | Finite volume -> Some volume
  | Not_computed -> None
  | Infinite -> Scc_base.Bug.fail __POS__ "a set without bounds"

let whole w =
  let width (r : Ranges.range) = Rat.sub r.high.value r.low.value in
  Array.fold_left (fun product r -> Rat.mul product (width r)) Rat.one w.ranges

type measures = { of_holds : Rat.t option; of_fails : Rat.t option; of_unknown : Rat.t option }

(* One of them that is not computed is what the others leave. *)
let measures w =
  let known = List.map measure [ w.holds; w.fails; w.unknown ] in
  let rest () = List.fold_left (fun rest m -> Rat.sub rest (Option.value m ~default:Rat.zero)) (whole w) known in
  let only_one = List.length (List.filter Option.is_none known) = 1 in
  let value m = if Option.is_none m && only_one then Some (rest ()) else m in
  match List.map value known with
  | [ of_holds; of_fails; of_unknown ] -> { of_holds; of_fails; of_unknown }
  | _ -> Scc_base.Bug.fail __POS__ "three sets"

type probability = Exactly of Rat.t | Between of Rat.t * Rat.t | Not_computed

let probability w =
  let of_all volume = Rat.div volume (whole w) in
  match measures w with
  | { of_holds = Some least; of_unknown = Some unknown; _ } ->
    if Rat.sign unknown = 0 then Exactly (of_all least)
    else Between (of_all least, of_all (Rat.add least unknown))
  | _ -> Not_computed
