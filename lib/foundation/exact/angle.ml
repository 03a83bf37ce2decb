let pi =
  Rat.make
    (Z.of_string "314159265358979323846264338327950288419716939937510")
    (Z.pow (Z.of_int 10) 50)

(* The series, of an angle from -pi/4 to pi/4. With a quantum of 2^-60 its terms are 0 after some twenty. *)
let series x ~quantum =
  let rec go n term cos sin =
    if Rat.sign term = 0 then (cos, sin)
    else
      let next = Rat.round_to (Rat.div (Rat.mul term x) (Rat.of_int (n + 1))) ~quantum in
      let sign = if n land 2 = 0 then term else Rat.neg term in
      if n land 1 = 0 then go (n + 1) next (Rat.add cos sign) sin else go (n + 1) next cos (Rat.add sin sign)
  in
  go 0 Rat.one Rat.zero Rat.zero

(* After Machin: pi = 16 atan (1/5) - 4 atan (1/239). Each of at most [bits] terms is off by half a quantum. *)
let pi_to ~bits =
  let quantum = Rat.power_of_two (-(bits + 8 + Rat.log_above (Rat.of_int bits))) in
  let arctangent n =
    let rec go k power sum =
      if Rat.sign power = 0 then sum
      else
        let term = Rat.round_to (Rat.div power (Rat.of_int ((2 * k) + 1))) ~quantum in
        go (k + 1)
          (Rat.round_to (Rat.div power (Rat.of_int (n * n))) ~quantum)
          (if k land 1 = 0 then Rat.add sum term else Rat.sub sum term)
    in
    go 0 (Rat.round_to (Rat.make Z.one (Z.of_int n)) ~quantum) Rat.zero
  in
  Rat.sub (Rat.mul (Rat.of_int 16) (arctangent 5)) (Rat.mul (Rat.of_int 4) (arctangent 239))

let near degrees ~pi ~quantum =
  let turned = Rat.modulo degrees (Rat.of_int 360) in
  let quarters = Z.to_int (Rat.floor (Rat.div (Rat.add turned (Rat.of_int 45)) (Rat.of_int 90))) in
  let rest = Rat.sub turned (Rat.of_int (90 * quarters)) in
  let x = Rat.round_to (Rat.div (Rat.mul rest pi) (Rat.of_int 180)) ~quantum in
  let c, s = if Rat.sign rest = 0 then (Rat.one, Rat.zero) else series x ~quantum in
  match quarters land 3 with 0 -> (c, s) | 1 -> (Rat.neg s, c) | 2 -> (Rat.neg c, Rat.neg s) | _ -> (s, Rat.neg c)

let cos_sin degrees = near degrees ~pi ~quantum:(Rat.power_of_two (-60))

(* There are fewer than [bits + 10] terms, each off by less than a quantum. *)
let cos_sin_to ~bits degrees =
  if bits <= 50 then cos_sin degrees
  else
    let more = bits + 10 + Rat.log_above (Rat.of_int bits) in
    near degrees ~pi:(pi_to ~bits:more) ~quantum:(Rat.power_of_two (-more))

(* The degrees are off by at most 10^9 * 180 / 3 * 10^-49: far below the error of the series. *)
let cos_sin_radians x = cos_sin (Rat.div (Rat.mul x (Rat.of_int 180)) pi)
