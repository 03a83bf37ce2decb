let pi =
  Rat.make
    (Z.of_string "314159265358979323846264338327950288419716939937510")
    (Z.pow (Z.of_int 10) 50)

let short = Rat.power_of_two (-60)

(* The series, of an angle from -pi/4 to pi/4, whose terms fall below 2^-60 after some twenty. *)
let series x =
  let rec go n term cos sin =
    if n > 24 then (cos, sin)
    else
      let next = Rat.round_to (Rat.div (Rat.mul term x) (Rat.of_int (n + 1))) ~quantum:short in
      let sign = if n land 2 = 0 then term else Rat.neg term in
      if n land 1 = 0 then go (n + 1) next (Rat.add cos sign) sin else go (n + 1) next cos (Rat.add sin sign)
  in
  go 0 Rat.one Rat.zero Rat.zero

let cos_sin degrees =
  let turned = Rat.modulo degrees (Rat.of_int 360) in
  let quarters = Z.to_int (Rat.floor (Rat.div (Rat.add turned (Rat.of_int 45)) (Rat.of_int 90))) in
  let rest = Rat.sub turned (Rat.of_int (90 * quarters)) in
  let x = Rat.round_to (Rat.div (Rat.mul rest pi) (Rat.of_int 180)) ~quantum:short in
  let c, s = if Rat.sign rest = 0 then (Rat.one, Rat.zero) else series x in
  match quarters land 3 with 0 -> (c, s) | 1 -> (Rat.neg s, c) | 2 -> (Rat.neg c, Rat.neg s) | _ -> (s, Rat.neg c)

(* The degrees are off by at most 10^9 * 180 / 3 * 10^-49: far below the error of the series. *)
let cos_sin_radians x = cos_sin (Rat.div (Rat.mul x (Rat.of_int 180)) pi)
