open Scc_decompose

type axis = X | Y | Z

(* That in which the normal is greatest. *)
let axis (s : Plane.t) =
  let less a b = Z.compare (Z.abs a) (Z.abs b) < 0 in
  if less s.a s.b then if less s.b s.c then Z else Y else if less s.a s.c then Z else X

(* 1 if what turns to the left as seen from in front does so as seen along the axis. *)
let facing (s : Plane.t) = function X -> Z.sign s.a | Y -> Z.sign s.b | Z -> Z.sign s.c

let exact axis (p : Homogeneous.t) (q : Homogeneous.t) (r : Homogeneous.t) =
  let seen (p : Homogeneous.t) = match axis with X -> (p.y, p.z) | Y -> (p.z, p.x) | Z -> (p.x, p.y) in
  let minor (a, b) (c, d) = Z.sub (Z.mul a d) (Z.mul b c) in
  let u = seen p and v = seen q and w = seen r in
  Z.sign (Z.add (Z.mul p.w (minor v w)) (Z.sub (Z.mul r.w (minor u v)) (Z.mul q.w (minor u w))))

(* Let u be 2^-53, and m and n the greatest magnitudes of both coordinates, which have relative errors of 3 u.
   Terms of order u^2 are left out. A difference is off by at most 6 u m, and its rounding by 2 u m. A product is
   off by 2 * 2 * 8 u m n, and its rounding by 4 u m n. The difference of two is off by twice that, and its
   rounding by 8 u m n: 80 u m n in all. Where that is tiny, a product may have underflowed; where a number is a
   NaN, no comparison holds. *)
let turn axis (p : Homogeneous.t) (q : Homogeneous.t) (r : Homogeneous.t) =
  let x (p : Homogeneous.t) = match axis with X -> p.near.ny | Y -> p.near.nz | Z -> p.near.nx in
  let y (p : Homogeneous.t) = match axis with X -> p.near.nz | Y -> p.near.nx | Z -> p.near.ny in
  let px = x p and py = y p in
  let h = ((x q -. px) *. (y r -. py)) -. ((y q -. py) *. (x r -. px)) in
  let greatest a b c = Float.max (Float.abs a) (Float.max (Float.abs b) (Float.abs c)) in
  let error = 0x1p-46 *. greatest px (x q) (x r) *. greatest py (y q) (y r) in
  if error > 0x1p-900 && h > error then 1
  else if error > 0x1p-900 && h < -.error then -1
  else if Homogeneous.equal r p || Homogeneous.equal r q then 0
  else exact axis p q r

let of_face corners =
  match Plane.through corners.(0) corners.(1) corners.(2) with
  | Some plane -> plane
  | None -> Scc_base.Bug.fail __POS__ "a straight angle of a face"

(* Some edge of the first polygon has the second one on its right. *)
let separated axis facing one other =
  let n = Array.length one in
  let separates k =
    let p = one.(k) and q = one.((k + 1) mod n) in
    Array.for_all (fun r -> facing * turn axis p q r <= 0) other
  in
  let rec some k = k < n && (separates k || some (k + 1)) in
  some 0

let share plane one other =
  let axis = axis plane in
  let facing = facing plane axis in
  not (separated axis facing one other || separated axis facing other one)

let holds plane polygon x =
  let n = Array.length polygon and axis = axis plane in
  let left k = facing plane axis * turn axis polygon.(k) polygon.((k + 1) mod n) x >= 0 in
  let rec from k = k = n || (left k && from (k + 1)) in
  from 0
