open Scc_exact
open Scc_geometry
open Scc_polyhedra

let room (x, y, z) (f : Obstacle.facet) =
  let n = Ivec.to_vec f.normal in
  let along = Linear.add (Linear.scale n.x x) (Linear.add (Linear.scale n.y y) (Linear.scale n.z z)) in
  Linear.sub (Linear.constant (Linear.dimension x) (Rat.make f.num f.den)) along
