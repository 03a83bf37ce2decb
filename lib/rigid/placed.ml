open Scc_exact
open Scc_geometry

type t = { solid : Solid.t; turned : Quaternion.t; at : Vec.t }

let of_motion (m : Motion.t) t = { solid = m.solid; turned = Motion.rotation m t; at = Motion.reference m t }
let point b p = Vec.add b.at (Quaternion.apply b.turned p)
let vertex b i = point b (Solid.vertex b.solid i)
let vertices b = Array.init (Array.length b.solid.vertices) (vertex b)
let corners b f = List.map (vertex b) (Solid.corners b.solid f)
let centroid b = point b b.solid.centroid

let fixed_solid b =
  if Quaternion.is_identity b.turned then b.solid
  else
    Solid.make ~id:b.solid.id b.solid.polyhedron (Mat.mul (Quaternion.to_mat b.turned) b.solid.linear)
