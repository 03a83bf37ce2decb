open Scc_exact
open Scc_geometry

type t = { solid : Solid.t; turned : Quaternion.t; at : Vec.t }

let point b p = Vec.add b.at (Quaternion.apply b.turned p)
let vertex b i = point b (Solid.vertex b.solid i)
let vertices b = Array.init (Array.length b.solid.vertices) (vertex b)

let integers b =
  let q = b.turned and s = b.solid in
  let norm = if Quaternion.is_identity q then Z.one else Quaternion.norm2 q in
  let place, d = Ivec.of_vec b.at in
  let own = Z.mul norm s.denominator in
  let den = Z.lcm d own in
  let scale = Z.divexact den own and place = Ivec.scale (Z.divexact den d) place in
  (Array.map (fun v -> Ivec.add place (Ivec.scale scale (Quaternion.turn q v))) s.vertices, den)

let over_one a b =
  let va, da = integers a and vb, db = integers b in
  let den = Z.lcm da db in
  let over d v = if Z.equal d den then v else Array.map (Ivec.scale (Z.divexact den d)) v in
  (over da va, over db vb, den)

let corners b f = List.map (vertex b) (Solid.corners b.solid f)
let centroid b = point b b.solid.centroid

let fixed_solid b =
  if Quaternion.is_identity b.turned then b.solid
  else Solid.turned (Quaternion.to_mat b.turned) b.solid
