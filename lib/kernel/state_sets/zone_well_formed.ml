open Scc_exact
open Scc_polyhedra
open Scc_offsets
open Scc_calculus
open Scc_semantics

let in_ranges (m : Model.t) (z : Zone.t) =
  Polyhedron.preimage (Ranges.box m.ranges) ~dimension:(Zone.dimension z) z.parameters

let not_over (m : Model.t) (z : Zone.t) =
  let zero = Linear.constant (Zone.dimension z) Rat.zero in
  let of_leaf (l : State.leaf) =
    Constraint.at_least z.ages.(l.leaf) zero
    :: List.map (fun d -> Constraint.greater (Zone_time.left z l.leaf d) zero) (Zone_time.lengths m l)
  in
  let of_clock (p : State.process) =
    let clock = z.clocks.(p.leaves.(0).leaf) in
    match Zone_time.to_split_instant m z p with
    | Some (_, left) -> [ Constraint.at_least clock zero; Constraint.greater left zero ]
    | None -> [ Constraint.equals clock zero ]
  in
  List.concat_map of_leaf (State.leaves z.skeleton)
  @ List.concat_map of_clock (Array.to_list z.skeleton.processes)

let bonds_touch (c : Zone_parts.context) (z : Zone.t) =
  let of_process (p : State.process) =
    let parts = Zone_parts.parts (Semantics.model c.semantics) z p in
    List.map (fun (b : State.bond) -> Zone_parts.joint c z parts (b.one, b.two)) (Array.to_list p.bonds)
  in
  List.concat_map of_process (Array.to_list z.skeleton.processes)

let convex (c : Zone_parts.context) (z : Zone.t) =
  let m = Semantics.model c.semantics in
  let set = Polyhedron.add_all z.set (not_over m z) in
  List.fold_left Polyhedron.inter set (in_ranges m z :: bonds_touch c z)

let overlap c pair = Half_space.overlap (Zone_parts.facets c pair)

let apart (c : Zone_parts.context) (z : Zone.t) =
  let cut regions (((a : Zone_parts.part), (b : Zone_parts.part)) as pair) =
    if a.leaf = b.leaf then regions
    else
      let interior = Polyhedron.of_constraints (Zone.dimension z) (overlap c pair) in
      List.concat_map (fun region -> Difference.pieces region interior) regions
  in
  List.fold_left cut [ z.set ] (Scc_data.Lists.pairs (Zone_parts.all (Semantics.model c.semantics) z))
