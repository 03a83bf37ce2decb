open Scc_exact

type point = Rat.t * Rat.t
type t = { a : Rat.t; b : Rat.t; c : Rat.t; d : Rat.t; e : Rat.t; f : Rat.t }

let zero = Rat.zero
let one = Rat.one
let identity = { a = one; b = zero; c = zero; d = one; e = zero; f = zero }
let is_identity m =
  Rat.equal m.a one && Rat.equal m.d one && List.for_all (fun q -> Rat.sign q = 0) [ m.b; m.c; m.e; m.f ]

let ( + ) = Rat.add
let ( * ) = Rat.mul
let apply m (x, y) = ((m.a * x) + (m.c * y) + m.e, (m.b * x) + (m.d * y) + m.f)

let compose m n =
  let column (x, y) = ((m.a * x) + (m.c * y), (m.b * x) + (m.d * y)) in
  let a, b = column (n.a, n.b) and c, d = column (n.c, n.d) and e, f = apply m (n.e, n.f) in
  { a; b; c; d; e; f }

let is_invertible m = not (Rat.equal (m.a * m.d) (m.b * m.c))
let scaling x y = { identity with a = x; d = y }
let translation e f = { identity with e; f }

let cos_sin = Angle.cos_sin

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
