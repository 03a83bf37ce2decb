open Scc_exact
open Scc_geometry
open Scc_polyhedra
open Scc_offsets
open Scc_calculus
open Scc_semantics
open Scc_state_sets
module Polyhedron = Scc_polyhedra.Polyhedron

type context = { semantics : Semantics.t; obstacle : Solid.t -> Solid.t -> Obstacle.t }

let context semantics =
  let memory = Scc_broad_phase.Obstacle_cache.create () in
  { semantics; obstacle = Scc_broad_phase.Obstacle_cache.find memory }

let where region constraints =
  let p = Polyhedron.add_all region constraints in
  if Polyhedron.is_empty p then [] else [ p ]

let zero_like f = Linear.constant (Linear.dimension f) Rat.zero

let by_sign f region =
  let zero = zero_like f in
  List.concat_map
    (fun constraint_ -> where region [ constraint_ ])
    [ Constraint.equals f zero; Constraint.greater f zero; Constraint.less f zero ]

let by_signs forms regions =
  List.fold_left (fun regions f -> List.concat_map (by_sign f) regions) regions forms

type part = { leaf : int; index : int; process : int; solid : Solid.t; place : Place.t; velocity : Vec.t }

let parts c (z : Zone.t) =
  let m = Semantics.model c.semantics in
  let of_leaf (p : State.process) (l : State.leaf) =
    let of_part index (part : Model.part) =
      let place = Zone.place z l.leaf part in
      { leaf = l.leaf; index; process = p.leaves.(0).leaf; solid = part.solid; place; velocity = p.velocity }
    in
    List.mapi of_part (Array.to_list m.leaves.(l.leaf).parts)
  in
  let of_process (p : State.process) = List.concat_map (of_leaf p) (Array.to_list p.leaves) in
  List.concat_map of_process (Array.to_list z.skeleton.processes)

let facets c (a, b) =
  Half_space.moving (c.obstacle a.solid b.solid) (Place.sub b.place a.place) (Vec.sub b.velocity a.velocity)

(* Disjoint pieces of where not all of the constraints hold. *)
let where_not region constraints =
  let on left c = List.concat_map (fun p -> where p [ c ]) left in
  let step (left, found) c = (on left c, found @ List.concat_map (on left) (Constraint.negation c)) in
  snd (List.fold_left step ([ region ], []) constraints)

let well_formed c (z : Zone.t) =
  let cut regions (a, b) =
    if a.leaf = b.leaf then regions
    else
      let interior = Half_space.overlap (facets c (a, b)) in
      List.concat_map (fun region -> where_not region interior) regions
  in
  List.fold_left cut [ z.set ] (Scc_data.Lists.pairs (parts c z))

let bonds_touch c (z : Zone.t) =
  let parts = parts c z in
  let memory = Feature_offsets.create () in
  let of_bond (b : State.bond) =
    let at (f : State.finish) = List.find (fun p -> p.leaf = f.at && p.index = f.site.part) parts in
    let one = at b.one and two = at b.two in
    let side part (f : State.finish) = { Feature_offsets.solid = part.solid; feature = f.site.feature } in
    let together = Feature_offsets.touching memory (side one b.one) (side two b.two) in
    Place.within together (Place.sub two.place one.place)
  in
  let of_process (p : State.process) = List.concat_map of_bond (Array.to_list p.bonds) in
  List.concat_map of_process (Array.to_list z.skeleton.processes)

(* {1 Cells} *)

(* The features that two leaves may meet in by channels that fit, as sets of offsets. *)
let meeting_features c (z : Zone.t) (a, b) =
  let home leaf = Option.get (State.home z.skeleton leaf) in
  let memory = Feature_offsets.create () in
  let fitting = Collisions.fitting c.semantics (home a.leaf, a.leaf) (home b.leaf, b.leaf) in
  let features part (channel : Behaviour.channel) =
    List.filter_map (fun (s : Site.t) -> if s.part = part.index then Some s.feature else None) channel.surface
  in
  let of_channels (one, two) =
    List.concat_map (fun f -> List.map (fun g -> (f, g)) (features b two)) (features a one)
  in
  let offsets (f, g) =
    Feature_offsets.touching memory { solid = a.solid; feature = f } { solid = b.solid; feature = g }
  in
  List.map offsets (List.concat_map of_channels fitting)

let by_features c z (a, b) region =
  let offset = Place.sub b.place a.place in
  let cut regions set = by_signs (List.map Constraint.to_form (Place.within set offset)) regions in
  List.fold_left cut [ region ] (meeting_features c z (a, b))

let cells c (z : Zone.t) =
  let cut regions (a, b) =
    if a.leaf = b.leaf then regions
    else
      let facets = facets c (a, b) in
      let rooms = List.map (fun (h : Half_space.t) -> h.room) facets in
      let of_region region =
        let apart = where_not region (Half_space.contact facets) in
        let closed = where region (Half_space.contact facets) in
        apart @ List.concat_map (by_features c z (a, b)) (by_signs rooms closed)
      in
      List.concat_map of_region regions
  in
  List.fold_left cut [ z.set ] (Scc_data.Lists.pairs (parts c z))
