type t = { w : Z.t; x : Z.t; y : Z.t; z : Z.t }

let identity = { w = Z.one; x = Z.zero; y = Z.zero; z = Z.zero }
let equal p q = Z.equal p.w q.w && Z.equal p.x q.x && Z.equal p.y q.y && Z.equal p.z q.z
let is_identity q = Z.sign q.x = 0 && Z.sign q.y = 0 && Z.sign q.z = 0

let rec first_sign = function
  | [] -> 0
  | c :: rest -> ( match Z.sign c with 0 -> first_sign rest | s -> s)

let make w x y z =
  match first_sign [ w; x; y; z ] with
  | 0 -> Scc_base.Bug.fail __POS__ "the rotation of the zero quaternion"
  | sign ->
    let g = Z.gcd (Z.gcd w x) (Z.gcd y z) in
    let g = if sign < 0 then Z.neg g else g in
    if Z.equal g Z.one then { w; x; y; z }
    else { w = Z.divexact w g; x = Z.divexact x g; y = Z.divexact y g; z = Z.divexact z g }

let of_rationals w (v : Vec.t) =
  let n, d = Ivec.of_vec v in
  let scale = Z.lcm d w.Q.den in
  let k = Z.divexact scale d in
  make (Z.mul w.Q.num (Z.divexact scale w.Q.den)) (Z.mul k n.x) (Z.mul k n.y) (Z.mul k n.z)

let cayley u = of_rationals Rat.one u

let mul p q =
  let ( * ) = Z.mul and ( + ) = Z.add and ( - ) = Z.sub in
  make
    ((p.w * q.w) - (p.x * q.x) - (p.y * q.y) - (p.z * q.z))
    ((p.w * q.x) + (p.x * q.w) + (p.y * q.z) - (p.z * q.y))
    ((p.w * q.y) - (p.x * q.z) + (p.y * q.w) + (p.z * q.x))
    ((p.w * q.z) + (p.x * q.y) - (p.y * q.x) + (p.z * q.w))

let inverse q = make q.w (Z.neg q.x) (Z.neg q.y) (Z.neg q.z)

let norm2 q = Z.add (Z.add (Z.mul q.w q.w) (Z.mul q.x q.x)) (Z.add (Z.mul q.y q.y) (Z.mul q.z q.z))

(* |q|^2 x + 2 w (v x x) + 2 v x (v x x). *)
let turn q (x : Ivec.t) =
  if is_identity q then x
  else
    let v = Ivec.make q.x q.y q.z in
    let c = Ivec.cross v x in
    let twice = Ivec.add (Ivec.scale q.w c) (Ivec.cross v c) in
    Ivec.add (Ivec.scale (norm2 q) x) (Ivec.scale (Z.of_int 2) twice)

let apply q x =
  if is_identity q then x
  else
    let n, d = Ivec.of_vec x in
    let r = turn q n and d = Z.mul d (norm2 q) in
    Vec.make (Rat.make r.x d) (Rat.make r.y d) (Rat.make r.z d)

let to_mat q =
  let column x y z = apply q (Vec.of_ints x y z) in
  Mat.transpose (Mat.make (column 1 0 0) (column 0 1 0) (column 0 0 1))

let greatest q = List.fold_left (fun m c -> Z.max m (Z.abs c)) Z.zero [ q.w; q.x; q.y; q.z ]

let round k q =
  let top = greatest q in
  let one = Z.shift_left Z.one k in
  if Z.leq top one then q
  else
    (* c one / top to the nearest integer, halves away from zero *)
    let near c =
      let twice = Z.shift_left (Z.mul (Z.abs c) one) 1 in
      let n = Z.fdiv (Z.add twice top) (Z.shift_left top 1) in
      if Z.sign c < 0 then Z.neg n else n
    in
    make (near q.w) (near q.x) (near q.y) (near q.z)

(* Scaled so that its greatest component is 2^k, the quaternion q has |q| >= 2^k, and rounding moves it by e with
   |e| <= sqrt(3)/2 (the greatest component is not moved). The angle between q and q + e, as vectors of four
   components, is at most asin(|e|/|q|), and a rotation differs from another by twice the angle between their
   quaternions; a point at distance d moves by at most d times that angle. With s = |e|/|q| <= sqrt(3)/2 2^-k
   <= 1/2, asin s <= 1.05 s, and 2 * 1.05 * sqrt(3)/2 < 2. *)
let round_error k = Rat.make (Z.of_int 2) (Z.shift_left Z.one k)
let bits q = Z.numbits (greatest q)

let compare p q =
  let c = Z.compare p.w q.w in
  if c <> 0 then c
  else
    let c = Z.compare p.x q.x in
    if c <> 0 then c
    else
      let c = Z.compare p.y q.y in
      if c <> 0 then c else Z.compare p.z q.z

let compare_lengths p q =
  let c = Z.compare (greatest p) (greatest q) in
  if c <> 0 then c else compare p q

let hash q = ((((((Z.hash q.w * 31) + Z.hash q.x) * 31) + Z.hash q.y) * 31) + Z.hash q.z) land max_int

let to_string q =
  Printf.sprintf "(%s, %s, %s, %s)" (Z.to_string q.w) (Z.to_string q.x) (Z.to_string q.y) (Z.to_string q.z)
