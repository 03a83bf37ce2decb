open Scc_exact

(* In units of 2^-precision. *)
let precision = 1024
let scaled (r : Rat.t) = Z.fdiv (Z.shift_left r.num precision) r.den

(* sqrt (2 / pi), rounded down: pi is less than this. *)
let factor =
  let pi_above = Rat.make (Z.of_string "314159265358979323846264338328") (Z.pow (Z.of_int 10) 29) in
  let squared = Z.shift_left (scaled (Rat.div (Rat.of_int 2) pi_above)) precision in
  Z.sqrt squared

(* The integral of exp (-x^2/2) from 0 to z <= 20: the sum of (-1)^j p(j) / (2j + 1), where p(0) = z and p(j+1)
   = p(j) h / (j + 1), with h = z^2/2 <= 200. Each p is rounded down, by less than a unit, and what the former
   ones have lost is multiplied by h^i / i! < e^200 < 2^289 at most: so p(j) is wrong by less than (j + 1) 2^289
   units, and as the p become less than a unit where j is much greater than h, all that follows is not more than
   that either. *)
let integral_below z =
  let half_square = Rat.div (Rat.mul z z) (Rat.of_int 2) in
  let rec go j power sum =
    if Z.sign power = 0 then (j, sum)
    else
      let term = Z.div power (Z.of_int ((2 * j) + 1)) in
      let sum = if j mod 2 = 0 then Z.add sum term else Z.sub sum term in
      let next =
        Z.div (Z.mul power half_square.num) (Z.mul half_square.den (Z.of_int (j + 1)))
      in
      go (j + 1) next sum
  in
  let j, sum = go 0 (scaled z) Z.zero in
  Z.sub sum (Z.shift_left (Z.of_int ((j + 1) * (j + 2))) 300)

let inside z =
  let product = Z.shift_right (Z.mul factor (integral_below z)) precision in
  Rat.make product (Z.shift_left Z.one precision)

let two_sided confidence =
  let of_parts i = Rat.make (Z.of_int i) (Z.of_int 1000) in
  let rec between low high =
    if high - low <= 1 then of_parts high
    else
      let middle = (low + high) / 2 in
      if Rat.compare (inside (of_parts middle)) confidence >= 0 then between low middle else between middle high
  in
  between 0 20_000
