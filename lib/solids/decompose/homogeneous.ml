open Scc_exact

type near = { nx : float; ny : float; nz : float }
type t = { x : Z.t; y : Z.t; z : Z.t; w : Z.t; near : near }

let near_integer n =
  let f = Z.to_float n in
  if Float.abs f < 0x1p1000 then f else Float.nan

let of_reduced x y z w =
  let d = near_integer w in
  { x; y; z; w; near = { nx = near_integer x /. d; ny = near_integer y /. d; nz = near_integer z /. d } }

let reduced x y z w =
  let g = Z.gcd (Z.gcd x y) (Z.gcd z w) in
  let g = if Z.sign w < 0 then Z.neg g else g in
  if Z.equal g Z.one then of_reduced x y z w
  else of_reduced (Z.divexact x g) (Z.divexact y g) (Z.divexact z g) (Z.divexact w g)

let of_vec v =
  let (n : Ivec.t), w = Ivec.of_vec v in
  reduced n.x n.y n.z w

let to_vec p = Vec.make (Rat.make p.x p.w) (Rat.make p.y p.w) (Rat.make p.z p.w)
let equal p q = Z.equal p.x q.x && Z.equal p.y q.y && Z.equal p.z q.z && Z.equal p.w q.w

let compare p q =
  let c = Z.compare p.x q.x in
  if c <> 0 then c
  else
    let c = Z.compare p.y q.y in
    if c <> 0 then c
    else
      let c = Z.compare p.z q.z in
      if c <> 0 then c else Z.compare p.w q.w

let hash p = (((((Z.hash p.x * 31) + Z.hash p.y) * 31) + Z.hash p.z) * 31) + Z.hash p.w

(* The combination of p and q in which a value that is linear in the four numbers, [at_p] and [at_q], is 0. *)
let crossing p at_p q at_q =
  let mix a b = Z.sub (Z.mul at_p b) (Z.mul at_q a) in
  reduced (mix p.x q.x) (mix p.y q.y) (mix p.z q.z) (mix p.w q.w)
