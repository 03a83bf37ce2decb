open Scc_exact
open Scc_rigid
open Scc_calculus
open Scc_semantics

type t = { momentum : Vec.t; angular : Vec.t; energy : Rat.t }

let zero = { momentum = Vec.zero; angular = Vec.zero; energy = Rat.zero }

let add a b =
  {
    momentum = Vec.add a.momentum b.momentum;
    angular = Vec.add a.angular b.angular;
    energy = Rat.add a.energy b.energy;
  }

let sub a b =
  {
    momentum = Vec.sub a.momentum b.momentum;
    angular = Vec.sub a.angular b.angular;
    energy = Rat.sub a.energy b.energy;
  }

let of_process m p =
  let { Impact.mass; velocity; spin } = Turn.mover m p in
  match mass with
  | None -> zero
  | Some mass ->
    {
      momentum = Mass.momentum mass ~velocity;
      angular = Mass.angular_momentum mass ~velocity ~spin ~about:Vec.zero;
      energy = Mass.energy mass ~velocity ~spin;
    }

let of_state m (s : State.t) = Array.fold_left (fun sum p -> add sum (of_process m p)) zero s.processes

let added m (t : Transition.t) =
  Option.map (fun before -> lazy (sub (of_state m t.target) (of_state m before))) t.rounded

let map f t =
  let vector (v : Vec.t) = Vec.make (f v.x) (f v.y) (f v.z) in
  { momentum = vector t.momentum; angular = vector t.angular; energy = f t.energy }

(* In units of 2^-128, each term rounded down. *)
type sum = { down : t; terms : int }

let no_sum = { down = zero; terms = 0 }
let unit = Rat.make Z.one (Z.shift_left Z.one 128)

let accumulate sum t =
  let down x = Rat.mul unit (Rat.make (Rat.floor (Rat.div x unit)) Z.one) in
  { down = add sum.down (map down t); terms = sum.terms + 1 }

let bounds sum =
  let width = Rat.mul unit (Rat.of_int sum.terms) in
  (sum.down, map (Rat.add width) sum.down)
