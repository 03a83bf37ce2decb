open Scc_exact
open Scc_polyhedra
open Scc_offsets
open Scc_calculus
open Scc_semantics
open Scc_state_sets
module Polyhedron = Scc_polyhedra.Polyhedron

(* The least affine space that two zones are in, as a zone without borders. *)
let around (a : Zone.t) (b : Zone.t) =
  let n = Array.length (Zone.coordinates a) in
  let along z =
    let forms = Zone.coordinates z in
    List.init (Zone.dimension z) (fun i -> Array.map (fun f -> Linear.coefficient f i) forms)
  in
  let here = Zone_form.sample a and there = Zone_form.sample b in
  let equalities = Hull.affine ~through:here ((Array.map2 Rat.sub there here :: along a) @ along b) in
  let set = Polyhedron.of_constraints n equalities in
  fst (Zone_form.canonical (Zone_form.of_coordinates a ~set ~basis:[||] (Array.init n (Linear.variable n))))

let directions (m : Model.t) (z : Zone.t) =
  let leaves = Array.length m.leaves in
  let along axis = List.init leaves (fun leaf -> List.nth (Place.coordinates z.places.(leaf)) axis) in
  let between forms = List.map (fun (f, g) -> Linear.sub f g) (Scc_data.Lists.pairs forms) in
  Array.to_list (Zone.coordinates z)
  @ List.concat_map between [ Array.to_list z.ages; along 0; along 1; along 2 ]
  |> List.filter (fun f -> not (Linear.is_constant f))
  |> List.sort_uniq Linear.compare

(* That two parts are apart by a plane between them. *)
let separations (c : Instant.context) (z : Zone.t) =
  let m = Semantics.model c.semantics in
  let of_pair (a, b) =
    let offset = Instant.offset a b in
    if Place.is_constant offset then []
    else
      List.concat_map Constraint.negation
        (Half_space.overlap (Half_space.still (c.obstacle a.solid b.solid) offset))
  in
  List.concat_map of_pair (Instant.pairs m z)

let join (c : Instant.context) (a : Zone.t) (b : Zone.t) =
  let both = if Zone_form.same_forms a b then a else around a b in
  let there (z : Zone.t) =
    if Zone_form.same_forms z both then z.set
    else
      let forms = Zone.coordinates z in
      Polyhedron.image z.set (Array.map (fun i -> forms.(i)) both.basis)
  in
  let a = there a and b = there b in
  let hold c = Polyhedron.implies a c && Polyhedron.implies b c in
  let set = Hull.join ~directions:(directions (Semantics.model c.semantics) both) a b in
  { both with set = Polyhedron.minimal (Polyhedron.add_all set (List.filter hold (separations c both))) }

let widen c (old : Zone.t) (joined : Zone.t) =
  if Zone_form.same_forms old joined then
    let kept = List.filter (Polyhedron.implies joined.set) (separations c joined) in
    { joined with set = Polyhedron.minimal (Polyhedron.add_all (Envelope.widen old.set joined.set) kept) }
  else joined

(* Where the coordinates of the second are what its basis makes of them, and in its set. *)
let meet (a : Zone.t) (b : Zone.t) =
  let forms = Zone.coordinates a in
  let chosen = Array.map (fun i -> forms.(i)) b.basis in
  let dimension = Zone.dimension a in
  let given i f = Constraint.equals forms.(i) (Linear.compose f ~dimension chosen) in
  let equalities = Array.to_list (Array.mapi given (Zone.coordinates b)) in
  let set = Polyhedron.inter (Polyhedron.add_all a.set equalities) (Polyhedron.preimage b.set ~dimension chosen) in
  fst (Zone_form.canonical { a with set })
