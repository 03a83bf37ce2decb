open Scc_exact
open Scc_calculus

let ( let* ) = Result.bind

let is_inertial = function Law.Inertial -> true | Law.Velocity _ -> false

let steers (m : Model.t) (p : State.process) =
  Array.exists (fun (l : State.leaf) -> not (is_inertial m.leaves.(l.leaf).law)) p.leaves
  && Option.is_some (State.mass m p)

(* The change of velocity that a leaf's law asks for. *)
let change (m : Model.t) ~time ~dt (p : State.process) (l : State.leaf) =
  let leaf = m.leaves.(l.leaf) in
  match leaf.law with
  | Inertial -> Ok Vec.zero
  | Velocity (x, y, z) ->
    let centre = State.centroid m l in
    let v =
      if Turn.spinning p then
        Vec.add p.velocity (Vec.cross p.spin (Vec.sub centre (State.centre_of_mass m p)))
      else p.velocity
    in
    let env : Law.variable -> Rat.t = function
      | X -> centre.x
      | Y -> centre.y
      | Z -> centre.z
      | Vx -> v.x
      | Vy -> v.y
      | Vz -> v.z
      | Mass -> leaf.mass
      | Time -> time
      | Dt -> dt
    in
    let eval e =
      Law.eval env e
      |> Result.map_error (fun fault -> Transition.Bad_law { leaf = l.leaf; fault })
    in
    let* x = eval x in
    let* y = eval y in
    let* z = eval z in
    Ok (Vec.sub (Vec.make x y z) v)

(* The whole takes the mean of the changes of its leaves, weighted by mass. *)
let steer_process (m : Model.t) ~time ~dt (p : State.process) =
  if not (steers m p) then Ok p
  else
    let add sum (l : State.leaf) =
      let* sum, total = sum in
      let* c = change m ~time ~dt p l in
      let mass = m.leaves.(l.leaf).mass in
      Ok (Vec.axpy mass c sum, Rat.add total mass)
    in
    let* sum, total = Array.fold_left add (Ok (Vec.zero, Rat.zero)) p.leaves in
    Ok (State.with_velocity (Vec.axpy (Rat.div Rat.one total) sum p.velocity) p)

type outcome = { state : State.t; rules : Rule.t list; rounded : Totals.t Lazy.t option }

let renewed m (s : State.t) =
  State.make ~processes:(List.map (Turn.renew m) (Array.to_list s.processes)) ~step:s.step ~time:s.time

(* The spins of the turns that begin, unless something would collide with them that does not otherwise. *)
let with_spins m (s : State.t) =
  if not (Turn.is_free m) then s
  else
    let d = Turn.step_length m s in
    let processes = List.map (Turn.midway m d) (Array.to_list s.processes) in
    let turning = State.make ~processes ~step:s.step ~time:s.time in
    match Encounter.colliding m turning with [] -> turning | _ :: _ -> s

let run (m : Model.t) (s : State.t) =
  match s.step with
  | None -> Scc_base.Bug.fail __POS__ "a steered state without a movement step"
  | Some step ->
    let dt = Rat.sub step.length step.remaining in
    let time = Option.value s.time ~default:Rat.zero in
    let s = match m.rigid with None -> s | Some _ -> renewed m s in
    let add done_ p =
      let* done_ = done_ in
      let* p = steer_process m ~time ~dt p in
      Ok (p :: done_)
    in
    let* processes = Array.fold_left add (Ok []) s.processes in
    let begun ~length s =
      let step = Some { State.remaining = length; length; phase = State.Steered } in
      State.make ~processes:(Array.to_list s.State.processes) ~step ~time:s.time
    in
    let steered = State.make ~processes ~step:s.step ~time:s.time in
    let rules = if Array.exists (steers m) s.processes || Option.is_none m.rigid then [ Rule.Steer ] else [] in
    (match m.rigid with
     | None -> Ok { state = begun ~length:m.timestep steered; rules; rounded = None }
     | Some _ ->
       let state, rounded = Round.run m (with_spins m steered) in
       let rules = if Option.is_some rounded then rules @ [ Rule.Round ] else rules in
       Ok { state = begun ~length:(Turn.step_length m state) state; rules; rounded })

let collide (m : Model.t) s =
  match m.rigid with
  | None -> List.exists Collision.colliding (Collision.contacts m s)
  | Some _ -> Encounter.colliding m s <> []

let settle m (s : State.t) =
  match s.step with
  | Some { phase = Due; _ } when not (collide m s) -> run m s
  | Some { phase = Due | Moving | Steered; _ } | None -> Ok { state = s; rules = []; rounded = None }
