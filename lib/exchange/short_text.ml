open Scc_exact
open Scc_calculus

let greatest = 24

let rat q =
  let text = Rat.to_string q in
  if String.length text <= greatest then text else "~" ^ Algebraic.to_decimal (Algebraic.of_rat q)

let vec (m : Model.t) (v : Vec.t) =
  if Option.is_none m.rigid then Vec.to_string v
  else Printf.sprintf "(%s, %s, %s)" (rat v.x) (rat v.y) (rat v.z)

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
