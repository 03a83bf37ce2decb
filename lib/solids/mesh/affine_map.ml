open Scc_exact

type t = { linear : Mat.t; shift : Vec.t }

let here = { linear = Mat.identity; shift = Vec.zero }
let move p v = Vec.add (Mat.apply p.linear v) p.shift
let inside outer inner = { linear = Mat.mul outer.linear inner.linear; shift = move outer inner.shift }
let max_bits = 4_000

let too_long p =
  let row (r : Vec.t) = Vec.bits r > max_bits in
  row p.linear.r0 || row p.linear.r1 || row p.linear.r2 || row p.shift

let mirrors p = Rat.sign (Mat.det p.linear) < 0
