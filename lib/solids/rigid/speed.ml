open Scc_exact
open Scc_geometry

(* Rounded up to ten bits or so. *)
let length v =
  let v, d = Ivec.of_vec v in
  let square = Rat.make (Ivec.dot v v) (Z.mul d d) in
  Rat.sqrt_above square.num square.den

let reach (solid : Solid.t) arm = Rat.add (length arm) solid.radius

(* The centroid keeps its distance from the centre that the solid turns about. *)
let reach_of (m : Motion.t) = reach m.solid (Vec.add m.arm (Quaternion.apply m.turned m.solid.centroid))

let speed_of_turning (m : Motion.t) =
  if Motion.turns m then Rat.mul (length m.spin) (reach_of m) else Rat.zero

let bound (a : Motion.t) (b : Motion.t) =
  let straight = length (Vec.sub b.velocity a.velocity) in
  Rat.short_above (Rat.add straight (Rat.add (speed_of_turning a) (speed_of_turning b)))

let grid a b ~resolution =
  let ratio = Rat.div (bound a b) resolution in
  let rec least k = if Z.leq ratio.num (Z.shift_left ratio.den k) then k else least (k + 1) in
  least (Int.max 0 (Z.numbits ratio.num - Z.numbits ratio.den - 1))
