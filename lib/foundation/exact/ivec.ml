type t = { x : Z.t; y : Z.t; z : Z.t }

let make x y z = { x; y; z }
let zero = make Z.zero Z.zero Z.zero
let of_ints x y z = make (Z.of_int x) (Z.of_int y) (Z.of_int z)
let add a b = make (Z.add a.x b.x) (Z.add a.y b.y) (Z.add a.z b.z)
let sub a b = make (Z.sub a.x b.x) (Z.sub a.y b.y) (Z.sub a.z b.z)
let neg a = make (Z.neg a.x) (Z.neg a.y) (Z.neg a.z)
let scale k a = make (Z.mul k a.x) (Z.mul k a.y) (Z.mul k a.z)
let dot a b = Z.add (Z.mul a.x b.x) (Z.add (Z.mul a.y b.y) (Z.mul a.z b.z))

let cross a b =
  make
    (Z.sub (Z.mul a.y b.z) (Z.mul a.z b.y))
    (Z.sub (Z.mul a.z b.x) (Z.mul a.x b.z))
    (Z.sub (Z.mul a.x b.y) (Z.mul a.y b.x))

let det a b c = dot a (cross b c)
let is_zero a = Z.sign a.x = 0 && Z.sign a.y = 0 && Z.sign a.z = 0
let equal a b = Z.equal a.x b.x && Z.equal a.y b.y && Z.equal a.z b.z

let compare a b =
  let c = Z.compare a.x b.x in
  if c <> 0 then c
  else
    let c = Z.compare a.y b.y in
    if c <> 0 then c else Z.compare a.z b.z

let hash a = (((Z.hash a.x * 31) + Z.hash a.y) * 31) + Z.hash a.z

let primitive a =
  let g = Z.gcd a.x (Z.gcd a.y a.z) in
  if Z.sign g = 0 || Z.equal g Z.one then a
  else make (Z.divexact a.x g) (Z.divexact a.y g) (Z.divexact a.z g)

let to_vec a = Vec.make (Q.of_bigint a.x) (Q.of_bigint a.y) (Q.of_bigint a.z)

let of_vecs vs =
  (* Coordinates of one vector often have one denominator. *)
  let lcm d q =
    let e = Q.den q in
    if Z.equal e Z.one || Z.equal e d then d else if Z.equal d Z.one then e else Z.lcm d e
  in
  let d =
    Array.fold_left (fun d (v : Vec.t) -> lcm (lcm (lcm d v.x) v.y) v.z) Z.one vs
  in
  let num q =
    let e = Q.den q in
    if Z.equal e d then Q.num q else Z.mul (Q.num q) (if Z.equal e Z.one then d else Z.divexact d e)
  in
  (Array.map (fun (v : Vec.t) -> make (num v.x) (num v.y) (num v.z)) vs, d)

let is_integral (v : Vec.t) =
  Z.equal (Q.den v.x) Z.one && Z.equal (Q.den v.y) Z.one && Z.equal (Q.den v.z) Z.one

let numerators (v : Vec.t) = make (Q.num v.x) (Q.num v.y) (Q.num v.z)

let of_vec v =
  if is_integral v then (numerators v, Z.one)
  else
    let a, d = of_vecs [| v |] in
    (a.(0), d)

let to_string a =
  Printf.sprintf "(%s, %s, %s)" (Z.to_string a.x) (Z.to_string a.y) (Z.to_string a.z)
