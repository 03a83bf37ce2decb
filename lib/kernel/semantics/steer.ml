open Scc_exact
open Scc_calculus

let steers = Process.steers
let rules = [ Rule.Steer ]

(* {1 What laws give} *)

(* Each motion once, in order, with all of its chance. *)
let distinct (n : _ Chances.t) = Scc_data.Lists.merged Given.compare n.add

(* How a leaf moves before its law is asked. *)
type present = { velocity : Vec.t; spin : Vec.t }

let environment (m : Model.t) ~time ~dt (l : State.leaf) centre { velocity; spin } (x : Law.variable) =
  match x with
  | X -> centre.Vec.x
  | Y -> centre.y
  | Z -> centre.z
  | Vx -> velocity.x
  | Vy -> velocity.y
  | Vz -> velocity.z
  | Wx -> spin.x
  | Wy -> spin.y
  | Wz -> spin.z
  | Mass -> m.leaves.(l.leaf).mass
  | Time -> time
  | Dt -> dt

let vector env (x, y, z) =
  let* x = Law.eval env x in
  let* y = Law.eval env y in
  let* z = Law.eval env z in
  Ok (Vec.make x y z)

let motion env (m : Law.motion) =
  let* velocity = vector env m.velocity in
  match m.spin with
  | None -> Ok { Given.velocity; spin = None }
  | Some spin -> Result.map (fun spin -> { Given.velocity; spin = Some spin }) (vector env spin)

(* Motions of no weight are not asked for. *)
let shares (n : _ Chances.t) env kicks =
  let share (k : Law.kick) =
    let* weight = n.weight env k.weight in
    match Rat.sign (n.value weight) with
    | 0 -> Ok []
    | s when s < 0 -> Error Law.Negative_weight
    | _ -> Result.map (fun given -> [ (given, weight) ]) (motion env k.motion)
  in
  let* shares = Result.map List.concat (Result.all share kicks) in
  match shares with
  | [] -> Error Law.No_weight
  | (_, w) :: rest ->
    let total = List.fold_left (fun sum (_, w) -> n.add sum w) w rest in
    Ok (distinct n (List.map (fun (given, w) -> (given, n.div w total)) shares))

(* A motion without a spin leaves it as it is, and is one with that spin if the law has others with spins. *)
let with_spins n law now shares =
  let keeps ((g : Given.t), _) = Option.is_none g.spin in
  if not (Law.gives_spin law && List.exists keeps shares) then shares
  else
    let spun ((g : Given.t), chance) = ({ g with spin = Some (Option.value g.spin ~default:now.spin) }, chance) in
    distinct n (List.map spun shares)

(* The motions that a leaf's law may ask for, with their chances. *)
let of_leaf (n : _ Chances.t) (c : Kinematics.setting) ~time ~dt (l : State.leaf) now =
  let env () = environment c.model ~time ~dt:(dt l) l (State.centroid c.model l) now in
  match c.model.leaves.(l.leaf).law with
  | Inertial -> Ok [ ({ Given.velocity = now.velocity; spin = None }, n.one) ]
  | Gives m -> Result.map (fun given -> [ (given, n.one) ]) (motion (env ()) m)
  | Choose kicks as law ->
    Result.map (with_spins n law now) (n.laws c l.leaf law (fun () -> shares n (env ()) kicks))

(* {2 Of a whole} *)

let plus (a : Given.t) (b : Given.t) =
  let spin = Option.merge Vec.add a.spin b.spin in
  { Given.velocity = Vec.add a.velocity b.velocity; spin }

(* Of two that are independent of each other. *)
let sums (n : _ Chances.t) some others =
  if List.compare_lengths some [] > 0 && List.length some * List.length others > Law.most_outcomes then
    Error Law.Too_many
  else
    let added (v, c) = List.rev_map (fun (w, d) -> (plus v w, n.mul c d)) others in
    Ok (distinct n (List.concat_map added some))

(* What becomes of a motion by a change with a weight. *)
let changed by { velocity; spin } (change : Given.t) =
  let spin = Option.map (fun w -> Vec.axpy by w spin) change.spin in
  { Given.velocity = Vec.axpy by change.velocity velocity; spin }

let change_from now mass (g : Given.t) =
  let change a b = Vec.scale mass (Vec.sub b a) in
  { Given.velocity = change now.velocity g.velocity; spin = Option.map (change now.spin) g.spin }

(* The whole takes the mean of the changes of its leaves, weighted by mass. *)
let of_whole (n : _ Chances.t) (c : Kinematics.setting) ~time ~dt (p : State.process) =
  let add sum (l : State.leaf) =
    let* sum, total = sum in
    let mass = c.model.leaves.(l.leaf).mass in
    let of_leaf =
      let now = { velocity = Turn.velocity_at c.model p (State.centroid c.model l); spin = p.spin } in
      let* motions = of_leaf n c ~time ~dt l now in
      sums n sum (List.map (fun (given, chance) -> (change_from now mass given, chance)) motions)
    in
    let* sum = Result.map_error (fun fault -> Transition.Bad_law { leaf = l.leaf; fault }) of_leaf in
    Ok (sum, Rat.add total mass)
  in
  let none = { Given.velocity = Vec.zero; spin = None } in
  let* sums, total = Array.fold_left add (Ok ([ (none, n.one) ], Rat.zero)) p.leaves in
  let mean = Rat.div Rat.one total and now = { velocity = p.velocity; spin = p.spin } in
  Ok (List.map (fun (sum, chance) -> (changed mean now sum, chance)) sums)

(* A leaf alone turns about its own centroid, and the mean over it is itself. *)
let motions n c ~time ~dt (p : State.process) =
  match p.leaves with
  | [| l |] ->
    Result.map_error
      (fun fault -> Transition.Bad_law { leaf = l.leaf; fault })
      (of_leaf n c ~time ~dt l { velocity = p.velocity; spin = p.spin })
  | _ -> of_whole n c ~time ~dt p

(* {1 Whose laws are asked, and when} *)

let waits (p : State.process) = match p.draw with Some Waits -> true | Some (Drawn _) | None -> false
let is_drawing (s : State.t) = Array.exists waits s.processes
let time (s : State.t) = Option.value s.time ~default:Rat.zero

(* How long ago the laws of a leaf were asked. *)
let dt (m : Model.t) (s : State.t) (l : State.leaf) =
  match s.step with Some step -> Rat.sub m.timestep step.remaining | None -> l.waited

(* At the end of the one movement step all; else each at the end of its own, if it does not collide. What falls
   apart by lot does so before. *)
let due c (s : State.t) =
  let is_due (p : State.process) = match p.phase with Some Due -> true | Some (Moving | Steered) | None -> false in
  match s.step with
  | Some { phase = Due; _ } when Lots.pending s -> None
  | Some { phase = Due; _ } -> if Collisions.collides c s then None else Some (fun _ -> true)
  | Some { phase = Moving | Steered; _ } -> None
  | None when Lots.pending s || not (Array.exists is_due s.processes) -> None
  | None ->
    let hit = Collisions.colliding c s in
    let which i = is_due s.processes.(i) && not (List.exists (fun (a, b) -> a = i || b = i) hit) in
    if List.exists which (List.init (Array.length s.processes) Fun.id) then Some which else None

(* They see their turns end. What cannot be evaluated is found here, also of those who draw later. *)
let ask (c : Semantics.t) ~which (s : State.t) =
  let (module K) = c.kinematics in
  let m = c.setting.model in
  let ask_one i p =
    if not (steers m p && which i) then Ok p
    else
      let p = K.renewed c.setting p in
      let* motions = motions Chances.rationals c.setting ~time:(time s) ~dt:(dt m s) p in
      let next = if Process.draws m p then State.Waits else Drawn (fst (List.hd motions)) in
      Ok (State.with_draw (Some next) p)
  in
  let* processes = Result.all Fun.id (List.mapi ask_one (Array.to_list s.processes)) in
  Ok (State.make ~processes ~step:s.step ~time:s.time)

(* All motions take effect at once, and steps begin. *)
let begin_steps (m : Model.t) (s : State.t) =
  let begin_own p =
    State.with_phase (Some State.Steered) (State.map_leaves (fun l -> { l with waited = Rat.zero }) p)
  in
  let begin_one (p : State.process) =
    match p.draw with
    | None | Some Waits -> p
    | Some (Drawn { velocity; spin }) ->
      let p = State.with_draw None (State.with_velocity velocity p) in
      let p = Option.fold ~none:p ~some:(fun spin -> Turn.spun m spin p) spin in
      if Model.of_each m then begin_own p else p
  in
  let step = Option.map (fun _ -> { State.remaining = m.timestep; phase = Steered }) s.step in
  State.at ~step ~time:s.time (State.mapi (fun _ p -> begin_one p) s)

(* Of the motions that have been drawn, those count that are not blocked. *)
let kicked (c : Semantics.t) (s : State.t) =
  let m = c.setting.model in
  let has_drawn i =
    let p = s.processes.(i) in
    Option.is_some p.draw && Process.draws m p
  in
  Blocked.waiting c ~kicked:has_drawn (begin_steps m s)

type outcome = { state : State.t; rules : Rule.t list; rounded : State.t option }

let settle (c : Semantics.t) (s : State.t) =
  let (module K) = c.kinematics in
  let m = c.setting.model in
  let colliding = Collisions.colliding c and parts (s : State.t) = Collisions.parts c s.processes in
  let s = K.at_contact c.setting ~colliding s in
  let* over, s =
    if Array.exists (fun (p : State.process) -> Option.is_some p.draw) s.processes then Ok (true, s)
    else
      let s = Blocked.stopped c s in
      match due c s with
      | None -> Ok (false, s)
      | Some which -> Result.map (fun s -> (true, s)) (ask c ~which s)
  in
  if is_drawing s then Ok { state = s; rules = []; rounded = None }
  else
    let used = if over && Array.exists (steers m) s.processes then rules else [] in
    (* If walkers bounce, each process begins by its own draw alone: Joint_draws.velocities rests on it. *)
    let steered = if over then Blocked.stopped c (kicked c s) else s in
    let state, rounded = K.begin_turns c.setting ~parts ~colliding (K.at_contact c.setting ~colliding steered) in
    Ok { state; rules = (if Option.is_some rounded then used @ [ Rule.Round ] else used); rounded }

(* {1 Draws} *)

let next_to_draw c (s : State.t) =
  Process.first_by_place (Semantics.model c) (List.filter waits (Array.to_list s.processes))

let drawers c (s : State.t) =
  Process.by_place (Semantics.model c) (List.filter waits (Array.to_list s.processes))

let chances_in n (c : Semantics.t) (s : State.t) p =
  motions n c.setting ~time:(time s) ~dt:(dt c.setting.model s) p

let chances c s p = chances_in Chances.rationals c s p

let draw_label (p : State.process) (given, chance) =
  Transition.Draw { first = p.leaves.(0).leaf; given; chance }

let drawn given (s : State.t) =
  let of_one _ p =
    match if waits p then given p else None with
    | Some g -> State.with_draw (Some (State.Drawn g)) p
    | None -> p
  in
  State.mapi of_one s
