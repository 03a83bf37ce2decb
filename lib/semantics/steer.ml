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
    let centre = Vec.add l.position (Model.leaf_centroid leaf) in
    let env : Law.variable -> Rat.t = function
      | X -> centre.x
      | Y -> centre.y
      | Z -> centre.z
      | Vx -> p.velocity.x
      | Vy -> p.velocity.y
      | Vz -> p.velocity.z
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
    Ok (Vec.sub (Vec.make x y z) p.velocity)

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

let run (m : Model.t) (s : State.t) =
  match s.step with
  | None -> Scc_base.Bug.fail __POS__ "a steered state without a movement step"
  | Some step ->
    let dt = Rat.sub step.length step.remaining in
    let time = Option.value s.time ~default:Rat.zero in
    let add done_ p =
      let* done_ = done_ in
      let* p = steer_process m ~time ~dt p in
      Ok (p :: done_)
    in
    let* processes = Array.fold_left add (Ok []) s.processes in
    let step = Some { State.remaining = m.timestep; length = m.timestep; phase = State.Steered } in
    Ok (State.make ~processes ~step ~time:s.time)

let settle m (s : State.t) =
  match s.step with
  | Some { phase = Due; _ } when not (List.exists Collision.colliding (Collision.contacts m s)) ->
    Result.map (fun s -> (s, true)) (run m s)
  | Some { phase = Due | Moving | Steered; _ } | None -> Ok (s, false)
