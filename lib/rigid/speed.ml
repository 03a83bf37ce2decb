open Scc_exact

(* n/d 2^k for an integer k of either sign, rounded up to an integer. *)
let scaled_up n d k = if k >= 0 then Z.cdiv (Z.shift_left n k) d else Z.cdiv n (Z.shift_left d (-k))

let over_power n k = if k >= 0 then Rat.make n (Z.shift_left Z.one k) else Q.of_bigint (Z.shift_left n (-k))

(* 2^(size - 1) < n/d < 2^(size + 1), for positive n and d. *)
let size n d = Z.numbits n - Z.numbits d
let bits = 10

(* Rounded up to [bits] bits or one more. *)
let shorten (q : Rat.t) =
  if Rat.sign q = 0 then Rat.zero
  else
    let k = bits - size q.num q.den in
    over_power (scaled_up q.num q.den k) k

(* The length of a vector, or more, by less than two in [bits] bits. *)
let length v =
  if Vec.is_zero v then Rat.zero
  else
    let v, d = Ivec.of_vec v in
    let n = Ivec.dot v v and d = Z.mul d d in
    let k = ((2 * bits) - size n d) asr 1 in
    let n = scaled_up n d (2 * k) in
    let root = Z.sqrt n in
    over_power (if Z.lt (Z.mul root root) n then Z.succ root else root) k

(* The centroid keeps its distance from the centre that the solid turns about. *)
let reach (m : Motion.t) =
  let centroid = Vec.add m.arm (Quaternion.apply m.turned m.solid.centroid) in
  Rat.add (length centroid) m.solid.radius

let speed_of_turning (m : Motion.t) =
  if Motion.turns m then Rat.mul (length m.spin) (reach m) else Rat.zero

let bound (a : Motion.t) (b : Motion.t) =
  let straight = length (Vec.sub b.velocity a.velocity) in
  shorten (Rat.add straight (Rat.add (speed_of_turning a) (speed_of_turning b)))

let grid a b ~resolution =
  let ratio = Rat.div (bound a b) resolution in
  let rec least k = if Z.leq ratio.num (Z.shift_left ratio.den k) then k else least (k + 1) in
  least (Int.max 0 (size ratio.num ratio.den - 1))
