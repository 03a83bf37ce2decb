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
    Semantics.with_model c.semantics (Fixed.offsets m (Array.map (fun f -> Linear.eval f point) z.parameters))
  else c.semantics

type part = { process : State.process; leaf : int; index : int; solid : Solid.t; place : Place.t }

let parts (m : Model.t) z (process : State.process) =
  let of_leaf (l : State.leaf) =
    let of_part index (p : Model.part) =
      let place = Zone.place z l.leaf p in
      { process; leaf = l.leaf; index; solid = p.solid; place }
    in
    List.mapi of_part (Array.to_list m.leaves.(l.leaf).parts)
  in
  List.concat_map of_leaf (Array.to_list process.leaves)

let two_of_different lists =
  let with_each (ps, qs) = List.concat_map (fun p -> List.map (fun q -> (p, q)) qs) ps in
  List.concat_map with_each (Scc_data.Lists.pairs lists)

let pairs m (z : Zone.t) = two_of_different (List.map (parts m z) (Array.to_list z.skeleton.processes))
let offset a b = Place.sub b.place a.place
let relative_velocity a b = Vec.sub b.process.velocity a.process.velocity
