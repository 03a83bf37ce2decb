open Scc_exact
open Scc_calculus

let greatest = 24

let rat q =
  let text = Rat.to_string q in
  if String.length text <= greatest then text else "~" ^ Algebraic.to_decimal (Algebraic.of_rat q)

(* What nobody would read to the end. *)
let endless = 60

(* Seven digits, cut off, and a power of ten: those of q 10^k, for a k with which it is great enough. *)
let scientific q =
  let size = Rat.abs q in
  let zeros = String.length (Z.to_string (Z.fdiv (Q.den size) (Q.num size))) + 8 in
  let digits = Z.to_string (Rat.floor (Rat.mul size (Q.of_bigint (Z.pow (Z.of_int 10) zeros)))) in
  let sign = if Rat.sign q < 0 then "-" else "" in
  Printf.sprintf "%s%c.%se%d" sign digits.[0] (String.sub digits 1 6) (String.length digits - 1 - zeros)

let least = Rat.make Z.one (Z.of_int 1000)
let greatest_plain = Rat.of_int 1_000_000_000

let exact q =
  let text = Rat.to_string q in
  if String.length text <= endless then text
  else
    let size = Rat.abs q in
    let plain = Rat.compare least size <= 0 && Rat.compare size greatest_plain < 0 in
    let about = if plain then Algebraic.to_decimal (Algebraic.of_rat q) else scientific q in
    Printf.sprintf "~%s (%d characters)" about (String.length text)

let vec (m : Model.t) (v : Vec.t) =
  let number = if Option.is_none m.rigid then exact else rat in
  Printf.sprintf "(%s, %s, %s)" (number v.x) (number v.y) (number v.z)

(* In proportion to w + |x| + |y| + |z| = 1 where the integers are long. *)
let quaternion (q : Quaternion.t) =
  let text = Quaternion.to_string q in
  if String.length text <= 2 * greatest then text
  else
    let size = List.fold_left (fun s z -> Z.add s (Z.abs z)) Z.zero [ q.w; q.x; q.y; q.z ] in
    let share z = Algebraic.to_decimal (Algebraic.of_rat (Rat.make z size)) in
    Printf.sprintf "~(%s, %s, %s, %s)" (share q.w) (share q.x) (share q.y) (share q.z)

let position m (l : State.leaf) =
  let place = vec m l.position in
  if Quaternion.is_identity l.turned then place else place ^ " turned " ^ quaternion l.turned

let motion m (p : State.process) =
  let velocity = "velocity " ^ vec m p.velocity in
  if Vec.is_zero p.spin then velocity else velocity ^ ", spin " ^ vec m p.spin
