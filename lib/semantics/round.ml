open Scc_exact
open Scc_calculus
open Scc_rigid

let replace (s : State.t) i p =
  let processes = List.mapi (fun j q -> if i = j then p else q) (Array.to_list s.processes) in
  State.make ~processes ~step:s.step ~time:s.time

(* Each process in turn, against the others as they are by then. *)
let each (s : State.t) f =
  let step (s, changed) i =
    match f s i s.State.processes.(i) with
    | Some p -> (replace s i p, true)
    | None -> (s, changed)
  in
  List.fold_left step (s, false) (List.init (Array.length s.processes) Fun.id)

let fixed m p = Option.is_none (State.mass m p)

let reach m p centre =
  Array.fold_left
    (fun far (l : State.leaf) ->
       let parts = Array.length m.Model.leaves.(l.leaf).parts in
       List.fold_left (fun far i -> Rat.max far (Turn.reach m ~centre l i)) far (List.init parts Fun.id))
    Rat.zero p.State.leaves

let orientation m k ~apart s i (p : State.process) =
  let old = p.leaves.(0).turned in
  let rounded = Quaternion.round k old in
  if fixed m p || Quaternion.equal old rounded then None
  else
    let centre = State.centre_of_mass m p in
    let by = Rat.mul (Quaternion.round_error k) (reach m p centre) in
    if not (apart s i ~by) then None
    else
      let turn = Quaternion.mul rounded (Quaternion.inverse old) in
      let move (l : State.leaf) =
        {
          l with
          position = Vec.add centre (Quaternion.apply turn (Vec.sub l.position centre));
          turned = Quaternion.mul turn l.turned;
        }
      in
      Some (State.map_leaves move p)

let quantum k = Rat.make Z.one (Z.shift_left Z.one k)

let near quantum (v : Vec.t) =
  let round x = Rat.round_to x ~quantum in
  Vec.make (round v.x) (round v.y) (round v.z)

(* An angular momentum is in proportion to inertia: the trace is that of the body however it is turned. *)
let kept m k (p : State.process) =
  if Vec.is_zero p.kept then p.kept
  else
    match Turn.mass_from_first m p with
    | Some mass -> near (Rat.mul (quantum k) (Mass.scale mass)) p.kept
    | None -> p.kept

let velocity m k (p : State.process) =
  let v = near (quantum k) p.velocity and spin = near (quantum k) p.spin and kept = kept m k p in
  if fixed m p || (Vec.equal v p.velocity && Vec.equal spin p.spin && Vec.equal kept p.kept) then None
  else Some (State.with_velocity v (State.with_kept kept (State.with_turn ~spin ~since:p.since p)))

(* How a body is turned does not matter to the ball that it spins in. *)
let settled (m : Model.t) (p : State.process) =
  let { Model.round_orientation; round_velocity; _ } = Turn.rigid m in
  let old = p.leaves.(0).turned in
  let turned k = Turn.spinning p || Quaternion.equal old (Quaternion.round k old) in
  Option.fold ~none:true ~some:(fun k -> Option.is_none (velocity m k p)) round_velocity
  && (fixed m p || Option.fold ~none:true ~some:turned round_orientation)

let velocities m k ~collides s =
  let rounded, changed = each s (fun _ _ p -> velocity m k p) in
  if not changed then (s, false)
  else if not (collides rounded) then (rounded, true)
  else
    each s (fun s i p ->
        match velocity m k p with
        | Some q when not (collides (replace s i q)) -> Some q
        | Some _ | None -> None)

let run m ~collides ~apart s =
  let { Model.round_orientation; round_velocity; _ } = Turn.rigid m in
  let rounded, turned =
    match round_orientation with None -> (s, false) | Some k -> each s (orientation m k ~apart)
  in
  let rounded, changed =
    match round_velocity with None -> (rounded, false) | Some k -> velocities m k ~collides rounded
  in
  (rounded, turned || changed)
