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
    let v = Turn.velocity_at m p centre in
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
  let add sum (l : State.leaf) =
    let* sum, total = sum in
    let* c = change m ~time ~dt p l in
    let mass = m.leaves.(l.leaf).mass in
    Ok (Vec.axpy mass c sum, Rat.add total mass)
  in
  let* sum, total = Array.fold_left add (Ok (Vec.zero, Rat.zero)) p.leaves in
  Ok (State.with_velocity (Vec.axpy (Rat.div Rat.one total) sum p.velocity) p)

type outcome = { state : State.t; rules : Rule.t list; rounded : State.t option }

(* New velocities for every process under a law, which sees it at the start of a turn. *)
let run (c : Semantics.t) (step : State.step) (s : State.t) =
  let (module K) = c.kinematics in
  let m = c.setting.model in
  let dt = Rat.sub m.timestep step.remaining in
  let time = Option.value s.time ~default:Rat.zero in
  let add done_ p =
    let* done_ = done_ in
    let* p = if steers m p then steer_process m ~time ~dt (K.renewed c.setting p) else Ok p in
    Ok (p :: done_)
  in
  let* processes = Array.fold_left add (Ok []) s.processes in
  let step = Some { State.remaining = m.timestep; phase = State.Steered } in
  Ok (State.make ~processes ~step ~time:s.time)

let steer c (s : State.t) =
  match s.step with
  | Some ({ phase = Due; _ } as step) when not (Collisions.collides c s) ->
    let* state = run c step s in
    Ok (state, if Array.exists (steers c.setting.model) s.processes then [ Rule.Steer ] else [])
  | Some { phase = Due | Moving | Steered; _ } | None -> Ok (s, [])

let settle (c : Semantics.t) (s : State.t) =
  let (module K) = c.kinematics in
  let colliding = Collisions.colliding c in
  let* steered, rules = steer c (K.at_contact c.setting ~colliding s) in
  let state, rounded = K.begin_turns c.setting ~colliding (K.at_contact c.setting ~colliding steered) in
  Ok { state; rules = (if Option.is_some rounded then rules @ [ Rule.Round ] else rules); rounded }
