open Scc_exact
open Scc_calculus

let ( let* ) = Result.bind

let steers = Process.steers

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
    let* c = change m ~time ~dt:(dt l) p l in
    let mass = m.leaves.(l.leaf).mass in
    Ok (Vec.axpy mass c sum, Rat.add total mass)
  in
  let* sum, total = Array.fold_left add (Ok (Vec.zero, Rat.zero)) p.leaves in
  Ok (State.with_velocity (Vec.axpy (Rat.div Rat.one total) sum p.velocity) p)

type outcome = { state : State.t; rules : Rule.t list; rounded : State.t option }

(* New velocities for processes under a law, which sees them at the start of a turn. *)
let run (c : Semantics.t) ~which ~dt ~steered ~step (s : State.t) =
  let (module K) = c.kinematics in
  let m = c.setting.model in
  let time = Option.value s.time ~default:Rat.zero in
  let add done_ (i, p) =
    let* done_ = done_ in
    let* p =
      if steers m p && which i then
        Result.map steered (steer_process m ~time ~dt (K.renewed c.setting p))
      else Ok p
    in
    Ok (p :: done_)
  in
  let* processes = List.fold_left add (Ok []) (List.mapi (fun i p -> (i, p)) (Array.to_list s.processes)) in
  Ok (State.make ~processes ~step ~time:s.time)

(* All at the end of the one movement step. *)
let of_all c (step : State.step) (s : State.t) =
  let m = Semantics.model c in
  let dt _ = Rat.sub m.timestep step.remaining in
  let step = Some { State.remaining = m.timestep; phase = State.Steered } in
  let* state = run c ~which:(fun _ -> true) ~dt ~steered:Fun.id ~step s in
  Ok (state, if Array.exists (steers m) s.processes then [ Rule.Steer ] else [])

(* Each at the end of its own, if it does not collide. *)
let of_each c (s : State.t) =
  let is_due (p : State.process) = match p.phase with Some Due -> true | Some (Moving | Steered) | None -> false in
  if not (Array.exists is_due s.processes) then Ok (s, [])
  else
    let hit = Collisions.colliding c s in
    let which i = is_due s.processes.(i) && not (List.exists (fun (a, b) -> a = i || b = i) hit) in
    if not (List.exists which (List.init (Array.length s.processes) Fun.id)) then Ok (s, [])
    else
      let dt (l : State.leaf) = l.waited in
      let steered p =
        State.with_phase (Some State.Steered) (State.map_leaves (fun l -> { l with waited = Rat.zero }) p)
      in
      let* state = run c ~which ~dt ~steered ~step:s.step s in
      Ok (state, [ Rule.Steer ])

let steer c (s : State.t) =
  match s.step with
  | Some ({ phase = Due; _ } as step) when not (Collisions.collides c s) -> of_all c step s
  | Some { phase = Due | Moving | Steered; _ } -> Ok (s, [])
  | None -> if Model.of_each (Semantics.model c) then of_each c s else Ok (s, [])

let settle (c : Semantics.t) (s : State.t) =
  let (module K) = c.kinematics in
  let colliding = Collisions.colliding c in
  let* steered, rules = steer c (K.at_contact c.setting ~colliding s) in
  let state, rounded = K.begin_turns c.setting ~colliding (K.at_contact c.setting ~colliding steered) in
  Ok { state; rules = (if Option.is_some rounded then rules @ [ Rule.Round ] else rules); rounded }
