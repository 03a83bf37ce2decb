open Scc_exact

type near = { na : float; nb : float; nc : float; nd : float }
type t = { a : Z.t; b : Z.t; c : Z.t; d : Z.t; near : near }

let of_reduced a b c d =
  let near = Homogeneous.near_integer in
  { a; b; c; d; near = { na = near a; nb = near b; nc = near c; nd = near d } }

let make (n : Ivec.t) (p : Homogeneous.t) =
  let scaled v = Z.mul p.w v in
  let level = Z.add (Z.mul n.x p.x) (Z.add (Z.mul n.y p.y) (Z.mul n.z p.z)) in
  let a = scaled n.x and b = scaled n.y and c = scaled n.z in
  let g = Z.gcd (Z.gcd a b) (Z.gcd c level) in
  of_reduced (Z.divexact a g) (Z.divexact b g) (Z.divexact c g) (Z.divexact level g)

let through (p : Homogeneous.t) (q : Homogeneous.t) (r : Homogeneous.t) =
  let from_p (q : Homogeneous.t) =
    let part a b = Z.sub (Z.mul a p.w) (Z.mul b q.w) in
    Ivec.make (part q.x p.x) (part q.y p.y) (part q.z p.z)
  in
  let n = Ivec.cross (from_p q) (from_p r) in
  if Ivec.is_zero n then None else Some (make n p)

let opposite s = of_reduced (Z.neg s.a) (Z.neg s.b) (Z.neg s.c) (Z.neg s.d)
let equal s t = Z.equal s.a t.a && Z.equal s.b t.b && Z.equal s.c t.c && Z.equal s.d t.d
let hash s = (((((Z.hash s.a * 31) + Z.hash s.b) * 31) + Z.hash s.c) * 31) + Z.hash s.d

let height s (p : Homogeneous.t) =
  Z.sub (Z.add (Z.mul s.a p.x) (Z.add (Z.mul s.b p.y) (Z.mul s.c p.z))) (Z.mul s.d p.w)

(* With u = 2^-53, each product of floats has a relative error of at most (3 + 1 + 1) u and terms of order
   u^2, and the level one of u. Three sums add at most 3 u times the sum of magnitudes, whose own rounding
   is of order u^2. So 2^-48 times that sum bounds the error. Products do not underflow: factors are 0 or at
   least 2^-1000 and 1. Where one overflows or is a NaN, no comparison holds. *)
let side s (p : Homogeneous.t) =
  let n = s.near and q = p.near in
  let x = n.na *. q.nx and y = n.nb *. q.ny and z = n.nc *. q.nz in
  let h = x +. y +. z -. n.nd in
  let error = 0x1p-48 *. (Float.abs x +. Float.abs y +. Float.abs z +. Float.abs n.nd) in
  if h > error then 1 else if h < -.error then -1 else Z.sign (height s p)
