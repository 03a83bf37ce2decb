open Scc_exact

type point = Rat.t * Rat.t
type t = { a : Rat.t; b : Rat.t; c : Rat.t; d : Rat.t; e : Rat.t; f : Rat.t }

let zero = Rat.zero
let one = Rat.one
let identity = { a = one; b = zero; c = zero; d = one; e = zero; f = zero }
let ( + ) = Rat.add
let ( * ) = Rat.mul
let apply m (x, y) = ((m.a * x) + (m.c * y) + m.e, (m.b * x) + (m.d * y) + m.f)

let compose m n =
  let column (x, y) = ((m.a * x) + (m.c * y), (m.b * x) + (m.d * y)) in
  let a, b = column (n.a, n.b) and c, d = column (n.c, n.d) and e, f = apply m (n.e, n.f) in
  { a; b; c; d; e; f }

let scaling x y = { identity with a = x; d = y }
let translation e f = { identity with e; f }

(* 50 digits of pi. *)
let pi =
  Rat.make
    (Z.of_string "314159265358979323846264338327950288419716939937510")
    (Z.pow (Z.of_int 10) 50)

let short = Rat.make Z.one (Z.shift_left Z.one 60)

(* The series, of an angle from -pi/4 to pi/4, whose terms fall below 2^-60 after some twenty. *)
let series x =
  let rec go n term cos sin =
    if Stdlib.( > ) n 24 then (cos, sin)
    else
      let next = Rat.round_to (Rat.div (term * x) (Rat.of_int (Stdlib.( + ) n 1))) ~quantum:short in
      let sign = if n land 2 = 0 then term else Rat.neg term in
      let after = Stdlib.( + ) n 1 in
      if n land 1 = 0 then go after next (cos + sign) sin else go after next cos (sin + sign)
  in
  go 0 one zero zero

let cos_sin degrees =
  let turned = Rat.modulo degrees (Rat.of_int 360) in
  let quarters = Z.to_int (Rat.floor (Rat.div (turned + Rat.of_int 45) (Rat.of_int 90))) in
  let rest = Rat.sub turned (Rat.of_int (Stdlib.( * ) 90 quarters)) in
  let x = Rat.round_to (Rat.div (rest * pi) (Rat.of_int 180)) ~quantum:short in
  let c, s = if Rat.sign rest = 0 then (one, zero) else series x in
  match quarters land 3 with 0 -> (c, s) | 1 -> (Rat.neg s, c) | 2 -> (Rat.neg c, Rat.neg s) | _ -> (s, Rat.neg c)

let rotation degrees =
  let c, s = cos_sin degrees in
  { identity with a = c; b = s; c = Rat.neg s; d = c }

let skewing axis degrees =
  let c, s = cos_sin degrees in
  if Rat.sign c = 0 then None
  else
    let t = Rat.div s c in
    Some (match axis with `X -> { identity with c = t } | `Y -> { identity with b = t })

let stretch m = Rat.abs m.a + Rat.abs m.b + Rat.abs m.c + Rat.abs m.d
