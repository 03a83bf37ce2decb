open Scc_exact

let right = Rat.mul Rat.half Angle.pi
let near = Rat.make Z.one (Z.of_int 20_000)
let quantum = Rat.power_of_two (-30)

(* Each of the four numbers of the quaternion is within 2^-31 + 2^-38 of its place, so that the quaternion, whose
   length is at least 7/10, is off by less than 2^-29 of its length. The rotation is off by at most four times
   that. *)
let rounded = Rat.power_of_two (-27)

(* The nearest number of 24 bits to a number that is not 0, as 32-bit numbers have them. *)
let single q =
  let size = Rat.abs q in
  let power = Z.numbits size.num - Z.numbits size.den in
  let power = if Rat.compare size (Rat.power_of_two power) < 0 then power - 1 else power in
  Rat.round_to q ~quantum:(Rat.power_of_two (power - 23))

let decimal q = Rat.round_to q ~quantum:(Rat.make Z.one (Z.of_int 10_000_000))

(* No multiple of a right angle but 0 can be written. Most files have 32-bit numbers. Seven digits make 1.5707963
   of a right angle, whose nearest 32-bit number is another one. *)
let written multiple angle =
  Rat.sign multiple <> 0
  && (Rat.equal (single angle) (single multiple) || Rat.equal angle (decimal multiple))

let exactly quaternion = Option.map (fun m -> (m, Rat.zero)) (Mat.of_quaternion quaternion)

let near_by (w, x, y, z) =
  let round q = Rat.round_to q ~quantum in
  Option.map (fun m -> (m, rounded)) (Mat.of_quaternion (round w, round x, round y, round z))

let rational (axis : Vec.t) length = Rat.equal (Rat.mul length length) (Vec.norm2 axis)

(* The quaternion (w, s axis / length). *)
let about (axis : Vec.t) length (w, s) =
  let s = Rat.div s length in
  (w, Rat.mul s axis.x, Rat.mul s axis.y, Rat.mul s axis.z)

let quarters (axis : Vec.t) length k =
  let zero = Rat.zero and one = Rat.one in
  match k land 3 with
  | 0 -> Some (Mat.identity, zero)
  | 2 -> exactly (zero, axis.x, axis.y, axis.z)
  | k ->
    let turn = about axis length (one, if k = 1 then one else Rat.of_int (-1)) in
    if rational axis length then exactly turn
    else
      let half (w, x, y, z) = (Rat.mul Rat.half w, Rat.mul Rat.half x, Rat.mul Rat.half y, Rat.mul Rat.half z) in
      near_by (half turn)

let rotation (axis : Vec.t) angle =
  if Rat.sign angle = 0 then Some (Mat.identity, Rat.zero)
  else if Vec.is_zero axis || Rat.compare (Rat.abs angle) (Rat.of_int 1_000_000) > 0 then None
  else
    let length = Rat.root (Vec.norm2 axis) in
    let k = Rat.round_to (Rat.div angle right) ~quantum:Rat.one in
    let multiple = Rat.mul k right in
    let off = Rat.abs (Rat.sub angle multiple) in
    if Rat.compare off near <= 0 then
      let off = if written multiple angle then Rat.zero else off in
      Option.map
        (fun (m, distance) -> (m, Rat.add off distance))
        (quarters axis length (Z.to_int (Z.logand k.num (Z.of_int 3))))
    else near_by (about axis length (Angle.cos_sin_radians (Rat.mul Rat.half angle)))
