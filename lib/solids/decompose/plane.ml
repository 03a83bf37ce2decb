open Scc_exact

type t = { a : Z.t; b : Z.t; c : Z.t; d : Z.t }

let make (n : Ivec.t) (p : Homogeneous.t) =
  let scaled v = Z.mul p.w v in
  let level = Z.add (Z.mul n.x p.x) (Z.add (Z.mul n.y p.y) (Z.mul n.z p.z)) in
  let a = scaled n.x and b = scaled n.y and c = scaled n.z in
  let g = Z.gcd (Z.gcd a b) (Z.gcd c level) in
  { a = Z.divexact a g; b = Z.divexact b g; c = Z.divexact c g; d = Z.divexact level g }

let through (p : Homogeneous.t) (q : Homogeneous.t) (r : Homogeneous.t) =
  let from_p (q : Homogeneous.t) =
    let part a b = Z.sub (Z.mul a p.w) (Z.mul b q.w) in
    Ivec.make (part q.x p.x) (part q.y p.y) (part q.z p.z)
  in
  let n = Ivec.cross (from_p q) (from_p r) in
  if Ivec.is_zero n then None else Some (make n p)

let opposite s = { a = Z.neg s.a; b = Z.neg s.b; c = Z.neg s.c; d = Z.neg s.d }
let equal s t = Z.equal s.a t.a && Z.equal s.b t.b && Z.equal s.c t.c && Z.equal s.d t.d
let hash s = (((((Z.hash s.a * 31) + Z.hash s.b) * 31) + Z.hash s.c) * 31) + Z.hash s.d

let height s (p : Homogeneous.t) =
  Z.sub (Z.add (Z.mul s.a p.x) (Z.add (Z.mul s.b p.y) (Z.mul s.c p.z))) (Z.mul s.d p.w)

let side s p = Z.sign (height s p)
