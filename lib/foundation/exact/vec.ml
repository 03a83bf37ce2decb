type t = { x : Rat.t; y : Rat.t; z : Rat.t }
type axis = X | Y | Z

let component axis v =
  match axis with
  | X -> v.x
  | Y -> v.y
  | Z -> v.z

let make x y z = { x; y; z }
let zero = make Rat.zero Rat.zero Rat.zero
let of_ints x y z = make (Rat.of_int x) (Rat.of_int y) (Rat.of_int z)

let unit = function
  | X -> of_ints 1 0 0
  | Y -> of_ints 0 1 0
  | Z -> of_ints 0 0 1

let add a b = make (Q.add a.x b.x) (Q.add a.y b.y) (Q.add a.z b.z)
let sub a b = make (Q.sub a.x b.x) (Q.sub a.y b.y) (Q.sub a.z b.z)
let neg a = make (Q.neg a.x) (Q.neg a.y) (Q.neg a.z)
let scale k a = make (Q.mul k a.x) (Q.mul k a.y) (Q.mul k a.z)
let middle a b = scale Rat.half (add a b)

(* Most velocities are along an axis: the other two numbers of a place are then as they were. *)
let axpy k a b =
  let along d x = if Q.sign d = 0 then x else Q.add (Q.mul k d) x in
  make (along a.x b.x) (along a.y b.y) (along a.z b.z)

let dot a b = Q.add (Q.mul a.x b.x) (Q.add (Q.mul a.y b.y) (Q.mul a.z b.z))

let cross a b =
  make
    (Q.sub (Q.mul a.y b.z) (Q.mul a.z b.y))
    (Q.sub (Q.mul a.z b.x) (Q.mul a.x b.z))
    (Q.sub (Q.mul a.x b.y) (Q.mul a.y b.x))

let norm2 a = dot a a
let is_zero a = Q.sign a.x = 0 && Q.sign a.y = 0 && Q.sign a.z = 0
let equal a b = Rat.equal a.x b.x && Rat.equal a.y b.y && Rat.equal a.z b.z

let compare a b =
  let c = Rat.compare a.x b.x in
  if c <> 0 then c
  else
    let c = Rat.compare a.y b.y in
    if c <> 0 then c else Rat.compare a.z b.z

let bits a = Int.max (Rat.bits a.x) (Int.max (Rat.bits a.y) (Rat.bits a.z))
let hash a = (((Rat.hash a.x * 31) + Rat.hash a.y) * 31) + Rat.hash a.z

let to_string a =
  Printf.sprintf "(%s, %s, %s)" (Rat.to_string a.x) (Rat.to_string a.y) (Rat.to_string a.z)

let in_short ?(most = 120) a =
  let text = to_string a in
  let about = Decimal.significant ~digits:6 in
  if String.length text <= most then text
  else Printf.sprintf "about (%s, %s, %s)" (about a.x) (about a.y) (about a.z)
