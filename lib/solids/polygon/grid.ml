open Scc_exact

type point = { x : Rat.t; y : Rat.t }
type t = { xs : Z.t array; ys : Z.t array; near_xs : float array; near_ys : float array; error : float }

let seen_along (n : Vec.t) (v : Vec.t) =
  let turned s x y = if s > 0 then { x; y } else { x = y; y = x } in
  if Rat.sign n.z <> 0 then turned (Rat.sign n.z) v.x v.y
  else if Rat.sign n.x <> 0 then turned (Rat.sign n.x) v.y v.z
  else turned (Rat.sign n.y) v.z v.x

let integers numbers =
  let common = Array.fold_left (fun d q -> Z.lcm d (Q.den q)) Z.one numbers in
  Array.map (fun q -> Z.mul (Q.num q) (Z.divexact common (Q.den q))) numbers

(* [error] bounds that of {!orient} in floats, by the greatest magnitudes m and n of the coordinates. Let u be
   2^-53. A coordinate is off by at most m u, a difference of two by 2 m u and its own rounding, 2 m u. So a
   product of differences, which are at most 2 m and 2 n, is off by 16 m n u and its own rounding, 4 m n u. The
   difference of two products is off by 2 * 20 m n u and 8 m n u, up to terms of order u^2: less than 64 m n u =
   2^-47 m n. A NaN or an infinity leaves the decision to integers; all numbers that are not 0 are at least 1. *)
let make points =
  let xs = integers (Array.map (fun p -> p.x) points) and ys = integers (Array.map (fun p -> p.y) points) in
  let near_xs = Array.map Z.to_float xs and near_ys = Array.map Z.to_float ys in
  let greatest = Array.fold_left (fun m x -> Float.max m (Float.abs x)) 0. in
  { xs; ys; near_xs; near_ys; error = 0x1p-47 *. greatest near_xs *. greatest near_ys }

let cross g a b c =
  let x k = Z.sub g.xs.(k) g.xs.(a) and y k = Z.sub g.ys.(k) g.ys.(a) in
  Z.sub (Z.mul (x b) (y c)) (Z.mul (y b) (x c))

let orient g a b c =
  let xs = g.near_xs and ys = g.near_ys in
  let x = xs.(a) and y = ys.(a) in
  let turn = ((xs.(b) -. x) *. (ys.(c) -. y)) -. ((ys.(b) -. y) *. (xs.(c) -. x)) in
  if turn > g.error then 1 else if turn < -.g.error then -1 else Z.sign (cross g a b c)

let compare_x g a b = Z.compare g.xs.(a) g.xs.(b)
let compare_y g a b = Z.compare g.ys.(a) g.ys.(b)
let same g a b = compare_x g a b = 0 && compare_y g a b = 0

(* Along the line of a and b the axis that tells them apart orders the points. *)
let strictly_within g a b c =
  let by compare = compare g a c * compare g c b in
  let x = by compare_x and y = by compare_y in
  if compare_x g a b <> 0 then x > 0 else y > 0

let between g a b c = orient g a b c = 0 && strictly_within g a b c
let on_closed g a b c = orient g a b c = 0 && (same g a c || same g b c || strictly_within g a b c)

let turns g a b c =
  let o = orient g a b c in
  o > 0 || (o = 0 && strictly_within g a c b)

let crosses g (a, b) (c, d) =
  orient g a b c * orient g a b d < 0 && orient g c d a * orient g c d b < 0

let meet g (a, b) (c, d) =
  crosses g (a, b) (c, d) || on_closed g a b c || on_closed g a b d || on_closed g c d a || on_closed g c d b

let twice_area g ring =
  let n = Array.length ring in
  let sum = ref Z.zero in
  for k = 1 to n - 2 do
    sum := Z.add !sum (cross g ring.(0) ring.(k) ring.(k + 1))
  done;
  Z.sign !sum

let squared g a b =
  let square z = Z.mul z z in
  Z.add (square (Z.sub g.xs.(a) g.xs.(b))) (square (Z.sub g.ys.(a) g.ys.(b)))
