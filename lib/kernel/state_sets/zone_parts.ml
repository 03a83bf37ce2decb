open Scc_data
open Scc_exact
open Scc_geometry
open Scc_polyhedra
open Scc_offsets
open Scc_calculus
open Scc_semantics

type context = {
  semantics : Semantics.t;
  obstacle : Solid.t -> Solid.t -> Obstacle.t;
  features : Feature_offsets.memory;
}

let context semantics =
  let memory = Scc_broad_phase.Obstacle_cache.create () in
  { semantics; obstacle = Scc_broad_phase.Obstacle_cache.find memory; features = Feature_offsets.create () }

let semantics_at c (z : Zone.t) point =
  let m = Semantics.model c.semantics in
  if Fixed.has_open_offsets m then
    Semantics.with_model c.semantics (Fixed.offsets m (Zone.values z point))
  else c.semantics

type part = { process : State.process; leaf : int; index : int; solid : Solid.t; place : Place.t }

let fitting c (a, b) = Collisions.fitting c.semantics (a.process, a.leaf) (b.process, b.leaf)

let parts (m : Model.t) z (process : State.process) =
  let of_leaf (l : State.leaf) =
    let of_part index (p : Model.part) =
      let place = Zone.place z l.leaf p in
      { process; leaf = l.leaf; index; solid = p.solid; place }
    in
    List.mapi of_part (Array.to_list m.leaves.(l.leaf).parts)
  in
  List.concat_map of_leaf (Array.to_list process.leaves)

let by_process m (z : Zone.t) = List.map (parts m z) (Array.to_list z.skeleton.processes)
let all m z = List.concat (by_process m z)
let pairs m z = List.concat_map (fun (ones, twos) -> Lists.product ones twos) (Lists.pairs (by_process m z))
let offset a b = Place.sub b.place a.place
let relative_velocity a b = Vec.sub b.process.velocity a.process.velocity
let facets c (a, b) = Half_space.moving (c.obstacle a.solid b.solid) (offset a b) (relative_velocity a b)

(* {1 Features} *)

let side part feature = { Feature_offsets.solid = part.solid; feature }
let sides part sites = List.map (side part) (Site.on part.index sites)
let facing (a, b) (ones, twos) = Lists.product (sides a ones) (sides b twos)
let of_end parts (f : State.finish) = List.find (fun p -> p.leaf = f.at && p.index = f.site.part) parts

let joint c (z : Zone.t) parts ((f : State.finish), (g : State.finish)) =
  let one = of_end parts f and two = of_end parts g in
  let together = Feature_offsets.touching c.features (side one f.site.feature) (side two g.site.feature) in
  let coordinates = Array.of_list (Place.coordinates (offset one two)) in
  Polyhedron.preimage together ~dimension:(Zone.dimension z) coordinates
