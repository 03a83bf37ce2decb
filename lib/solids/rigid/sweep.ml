open Scc_exact
open Scc_geometry

type outcome = Never | At of Algebraic.t

(* How far an axis separates from an instant on, in the time of {!Axis.pair}, in which all ends at 1. *)
type reach = Not_at_all | To_the_end | Until of Bernstein.root

(* The least of the instants after which one of the conditions fails. *)
let reach p guess axis start =
  let low = Bernstein.low start in
  let condition = Axis.condition p axis in
  let count = Axis.conditions p axis in
  let rec all k reached =
    if k = count then reached
    else if Axis_guess.holds guess axis k ~low then all (k + 1) reached
    else
      let until = match reached with Until root -> Bernstein.high root | _ -> Rat.one in
      match Bernstein.first_negative (condition k) ~after:start ~until with
      | At_once -> Not_at_all
      | Nowhere -> all (k + 1) reached
      | Later root -> (
          match reached with
          | Until other when Bernstein.compare other root <= 0 -> all (k + 1) reached
          | _ -> all (k + 1) (Until root))
  in
  if Axis.parallel p axis then Not_at_all else all 0 To_the_end

(* So narrow that the width does not count beside the errors of floats. *)
let narrow = Rat.make Z.one (Z.shift_left Z.one 48)

(* The interiors are disjoint up to [start], which an axis may have been left at. An axis separates on finitely
   many intervals and each step goes to the end of one, so there are finitely many steps. When no axis goes on
   beyond [start], none separates right after it: an axis that did would, its conditions being closed, do so at
   [start] too. *)
let rec sweep p guess start left =
  let start = Bernstein.narrow start ~width:narrow in
  let rec choose axes =
    match axes () with
    | Seq.Nil -> Some start
    | Seq.Cons (axis, others) -> (
        if Option.fold ~none:false ~some:(Axis.equal axis) left then choose others
        else
          match reach p guess axis start with
          | Not_at_all -> choose others
          | To_the_end -> None
          | Until root -> sweep p guess root (Some axis))
  in
  choose (Axis_guess.candidates guess ~low:(Bernstein.low start) ~high:(Bernstein.high start))

let first_penetration a b ~from ~until =
  if Rat.compare from until >= 0 then Never
  else
    let p = Axis.pair a b ~from ~until in
    match sweep p (Axis_guess.make p) (Bernstein.rational Rat.zero) None with
    | None -> Never
    | Some instant -> At (Bernstein.to_algebraic instant ~scale:p.length ~shift:from)

let relation a b t =
  let a, at = Motion.placed a t and b, bt = Motion.placed b t in
  Obstacle.relation (Obstacle.make a b) (Vec.sub bt at)
