open Scc_exact
open Scc_polyhedra
open Scc_offsets
open Scc_calculus
open Scc_semantics
open Instant
open Scc_state_sets

(* {1 What is convex} *)

let in_ranges c (z : Zone.t) =
  Polyhedron.preimage (Ranges.box (Semantics.model c.semantics).ranges) ~dimension:(Zone.dimension z) z.parameters

let bonds_touch c (z : Zone.t) =
  let m = Semantics.model c.semantics in
  let of_process (p : State.process) =
    let parts = parts m z p in
    let at (f : State.finish) = List.find (fun part -> part.leaf = f.at && part.index = f.site.part) parts in
    let side part (f : State.finish) = { Feature_offsets.solid = part.solid; feature = f.site.feature } in
    let of_bond (b : State.bond) =
      let one = at b.one and two = at b.two in
      let together = Feature_offsets.touching c.features (side one b.one) (side two b.two) in
      let x, y, z' = offset one two in
      Polyhedron.preimage together ~dimension:(Zone.dimension z) [| x; y; z' |]
    in
    List.map of_bond (Array.to_list p.bonds)
  in
  List.concat_map of_process (Array.to_list z.skeleton.processes)

(* {1 Apart} *)

let apart c (z : Zone.t) =
  let m = Semantics.model c.semantics in
  let all = List.concat_map (parts m z) (Array.to_list z.skeleton.processes) in
  let cut regions (a, b) =
    if a.leaf = b.leaf then regions
    else
      let facets = Half_space.still (c.obstacle a.solid b.solid) (offset a b) in
      let interior = Polyhedron.of_constraints (Zone.dimension z) (Half_space.overlap facets) in
      List.concat_map (fun region -> Difference.pieces region interior) regions
  in
  List.fold_left cut [ z.set ] (Scc_data.Lists.pairs all)

(* Whether it is an instant of the grid is all that the discrete rules ask of clocks. *)
let by_clocks (z : Zone.t) region =
  let cut regions clock =
    let zero = Linear.constant (Zone.dimension z) Rat.zero in
    let some c region =
      let p = Polyhedron.add region c in
      if Polyhedron.is_empty p then [] else [ p ]
    in
    List.concat_map (some (Constraint.equals clock zero)) regions
    @ List.concat_map (some (Constraint.greater clock zero)) regions
  in
  Array.fold_left cut [ region ] z.clocks

let pieces c (z : Zone.t) =
  let convex = Polyhedron.add_all z.set (Passing.not_over c z) in
  let set = List.fold_left Polyhedron.inter convex (in_ranges c z :: bonds_touch c z) in
  if Polyhedron.is_empty set then []
  else List.map (fun set -> { z with set }) (List.concat_map (by_clocks z) (apart c { z with set }))
