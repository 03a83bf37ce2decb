open Scc_exact
open Scc_geometry

type t = {
  solid : Solid.t;
  turned : Quaternion.t;
  arm : Vec.t;
  centre : Vec.t;
  velocity : Vec.t;
  spin : Vec.t;
  since : Rat.t;
}

let turns m = not (Vec.is_zero m.spin)

(* C(spin (since + t)/2). *)
let turn m t =
  if turns m then Quaternion.cayley (Vec.scale (Rat.mul Rat.half (Rat.add m.since t)) m.spin)
  else Quaternion.identity

let rotation m t = Quaternion.mul (turn m t) m.turned
let centre m t = Vec.axpy t m.velocity m.centre
let reference m t = Vec.add (centre m t) (Quaternion.apply (turn m t) m.arm)

let point m t p =
  Vec.add (centre m t) (Quaternion.apply (turn m t) (Vec.add m.arm (Quaternion.apply m.turned p)))

let vertices m t =
  let reference = reference m t and rotation = rotation m t in
  let vertex i = Vec.add reference (Quaternion.apply rotation (Solid.vertex m.solid i)) in
  Array.init (Array.length m.solid.vertices) vertex

let placed m t =
  let rotation = rotation m t in
  let solid =
    if Quaternion.is_identity rotation then m.solid
    else Solid.turned (Quaternion.to_mat rotation) m.solid
  in
  (solid, reference m t)
