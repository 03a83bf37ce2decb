open Scc_exact

(* q 2^k for an integer k of either sign, rounded up to an integer. *)
let scaled_up q k =
  let n = q.Q.num and d = q.Q.den in
  if k >= 0 then Z.cdiv (Z.shift_left n k) d else Z.cdiv n (Z.shift_left d (-k))

let over_power n k = if k >= 0 then Rat.make n (Z.shift_left Z.one k) else Q.of_bigint (Z.shift_left n (-k))

(* 2^(size - 1) < q < 2^(size + 1), for q > 0. *)
let size q = Z.numbits q.Q.num - Z.numbits q.Q.den
let bits = 10

(* Rounded up to [bits] bits or one more. *)
let shorten q =
  if Rat.sign q = 0 then Rat.zero
  else
    let k = bits - size q in
    over_power (scaled_up q k) k

(* At least the square root, too great by less than two in [bits] bits. *)
let root_up q =
  if Rat.sign q = 0 then Rat.zero
  else
    let k = ((2 * bits) - size q) asr 1 in
    let n = scaled_up q (2 * k) in
    let root = Z.sqrt n in
    over_power (if Z.lt (Z.mul root root) n then Z.succ root else root) k

(* The centroid keeps its distance from the centre that the solid turns about. *)
let reach (m : Motion.t) =
  let centroid = Vec.add m.arm (Quaternion.apply m.turned m.solid.centroid) in
  Rat.add (root_up (Vec.norm2 centroid)) m.solid.radius

let speed_of_turning (m : Motion.t) =
  if Motion.turns m then Rat.mul (root_up (Vec.norm2 m.spin)) (reach m) else Rat.zero

let bound (a : Motion.t) (b : Motion.t) =
  let straight = root_up (Vec.norm2 (Vec.sub b.velocity a.velocity)) in
  shorten (Rat.add straight (Rat.add (speed_of_turning a) (speed_of_turning b)))

let grid a b ~resolution =
  let ratio = Rat.div (bound a b) resolution in
  let rec least k = if Z.leq ratio.num (Z.shift_left ratio.den k) then k else least (k + 1) in
  least (Int.max 0 (size ratio - 1))
