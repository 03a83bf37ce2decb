type t = { r0 : Vec.t; r1 : Vec.t; r2 : Vec.t }

let make r0 r1 r2 = { r0; r1; r2 }
let diagonal (d : Vec.t) =
  make (Vec.make d.x Q.zero Q.zero) (Vec.make Q.zero d.y Q.zero) (Vec.make Q.zero Q.zero d.z)

let identity = diagonal (Vec.of_ints 1 1 1)
let apply m v = Vec.make (Vec.dot m.r0 v) (Vec.dot m.r1 v) (Vec.dot m.r2 v)

let transpose m =
  make
    (Vec.make m.r0.x m.r1.x m.r2.x)
    (Vec.make m.r0.y m.r1.y m.r2.y)
    (Vec.make m.r0.z m.r1.z m.r2.z)

let mul a b =
  let bt = transpose b in
  make (apply bt a.r0) (apply bt a.r1) (apply bt a.r2)

let add a b = make (Vec.add a.r0 b.r0) (Vec.add a.r1 b.r1) (Vec.add a.r2 b.r2)
let scale k a = make (Vec.scale k a.r0) (Vec.scale k a.r1) (Vec.scale k a.r2)
let det m = Vec.dot m.r0 (Vec.cross m.r1 m.r2)

let inverse m =
  let d = det m in
  if Q.sign d = 0 then None
  else
    let adjugate =
      transpose (make (Vec.cross m.r1 m.r2) (Vec.cross m.r2 m.r0) (Vec.cross m.r0 m.r1))
    in
    Some (scale (Q.inv d) adjugate)

let of_quaternion (w, x, y, z) =
  let ( + ) = Q.add and ( - ) = Q.sub and ( * ) = Q.mul in
  let n = (w * w) + (x * x) + (y * y) + (z * z) in
  if Q.sign n = 0 then None
  else
    let two a = a + a in
    let rows =
      make
        (Vec.make ((w * w) + (x * x) - (y * y) - (z * z)) (two ((x * y) - (w * z))) (two ((x * z) + (w * y))))
        (Vec.make (two ((x * y) + (w * z))) ((w * w) - (x * x) + (y * y) - (z * z)) (two ((y * z) - (w * x))))
        (Vec.make (two ((x * z) - (w * y))) (two ((y * z) + (w * x))) ((w * w) - (x * x) - (y * y) + (z * z)))
    in
    Some (scale (Q.inv n) rows)

let equal a b = Vec.equal a.r0 b.r0 && Vec.equal a.r1 b.r1 && Vec.equal a.r2 b.r2

let hash a = (((Vec.hash a.r0 * 31) + Vec.hash a.r1) * 31) + Vec.hash a.r2
