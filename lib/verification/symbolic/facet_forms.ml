open Scc_exact
open Scc_geometry
open Scc_polyhedra

let room (x, y, z) (f : Obstacle.facet) =
  let n = Ivec.to_vec f.normal in
  let less rest (a, form) = if Rat.sign a = 0 then rest else Linear.sub rest (Linear.scale a form) in
  let plane = Linear.constant (Linear.dimension x) (Rat.make f.num f.den) in
  List.fold_left less plane [ (n.x, x); (n.y, y); (n.z, z) ]
