open Scc_exact
open Scc_calculus

let least = Option.merge Rat.min

let horizon (m : Model.t) (p : State.process) =
  Array.fold_left
    (fun h (l : State.leaf) -> least h (Behaviours.horizon m.definitions l.behaviour))
    None p.leaves

let to_split_instant m p =
  match Process.running_clock m p with
  | Some (step, clock) -> Some (Rat.sub step clock)
  | None -> None

(* The time to the end of the first turn that ends. *)
let turn_left (s : State.t) = Array.fold_left (fun d p -> least d (Turn.left p)) None s.processes

(* The time to the end of the first movement step that ends, of all or of one process. *)
let step_left (m : Model.t) (s : State.t) =
  let of_process (p : State.process) =
    match p.phase with Some _ -> Some (Rat.sub m.timestep p.leaves.(0).waited) | None -> None
  in
  match s.step with
  | Some step -> Some step.remaining
  | None when Model.of_each m -> Array.fold_left (fun d p -> least d (of_process p)) None s.processes
  | None -> None

let wait m p = least (horizon m p) (least (to_split_instant m p) (Lots.wait m p))

let delay (c : Semantics.t) (s : State.t) =
  let (module K) = c.kinematics in
  let m = c.setting.model in
  let next = Array.fold_left (fun d p -> least d (wait m p)) None s.processes in
  let steered = Array.exists (Steer.steers m) s.processes in
  let turn = turn_left s in
  let step = step_left m s in
  let limit = least turn (if steered then least next step else next) in
  let contact = Collisions.first_time_of_contact c s.processes ~limit in
  (* what waits to be rounded goes another way when its next turn begins *)
  let nothing_ahead () =
    (not steered) && Option.is_none next
    && Array.for_all (K.settled c.setting) s.processes
    && K.none_ahead c.setting (Collisions.parts c s.processes)
  in
  match least limit contact with
  | None -> None
  | Some _ when Option.is_some turn && nothing_ahead () -> None
  | Some d -> least (Some d) step

(* The split clock runs on, and starts anew when a further bond can be released, which takes an eps that expires;
   one that changes nothing of that leaves the clock alone (reading I-9). Where bonds may be released at any time,
   it stands still. *)
let gains_split m (p : State.process) aged =
  Array.exists (fun b -> (not (Process.releasable m p b)) && Process.releasable m aged b) p.bonds

let age_clock (m : Model.t) d (p : State.process) aged =
  let expires = match horizon m p with Some h -> Rat.compare h d <= 0 | None -> false in
  if expires && gains_split m p aged then Some Rat.zero
  else
    match Process.running_clock m p with
    | Some (step, clock) -> Some (Rat.modulo (Rat.add clock d) step)
    | None -> p.clock

(* Where no eps is exposed and no clock runs, nothing ages. *)
let age_process (m : Model.t) d (p : State.process) =
  let ageless = Option.is_none p.clock && Option.is_none p.lots && Option.is_none (horizon m p) in
  if Rat.sign d = 0 || ageless then p
  else
    let age (l : State.leaf) = { l with behaviour = Behaviours.pass m.definitions d l.behaviour } in
    let aged = State.map_leaves age p in
    State.with_clock (age_clock m d p aged) (Lots.pass m d aged)

let pass_process m d p = Turn.pass m d (age_process m d p)

(* Its own movement step goes on, or is over. *)
let pass_own_step (m : Model.t) d (p : State.process) =
  match p.phase with
  | None -> p
  | Some _ ->
    let p = State.map_leaves (fun l -> { l with waited = Rat.add l.waited d }) p in
    State.with_phase (Some (if Rat.compare p.leaves.(0).waited m.timestep < 0 then Moving else Due)) p

(* Where nothing is steered, time may pass over the ends of steps: they come every timestep. *)
let pass_step (m : Model.t) d (step : State.step) : State.step =
  let beyond = Rat.sub d step.remaining in
  let into = if Rat.sign beyond < 0 then beyond else Rat.modulo beyond m.timestep in
  match Rat.sign into with
  | 0 -> { remaining = Rat.zero; phase = Due }
  | s when s < 0 -> { remaining = Rat.neg into; phase = Moving }
  | _ -> { remaining = Rat.sub m.timestep into; phase = Moving }

let pass_within m d (s : State.t) =
  State.mapi (fun _ p -> Turn.ended m (pass_own_step m d (pass_process m d p))) s
  |> State.at ~step:(Option.map (pass_step m d) s.step) ~time:(Option.map (Rat.add d) s.time)

(* Turns begin anew at the end of each. *)
let rec pass (c : Semantics.t) d (s : State.t) =
  let m = c.setting.model in
  match turn_left s with
  | Some left when Rat.compare d left > 0 -> (
      match Steer.settle c (pass_within m left s) with
      | Ok next -> pass c (Rat.sub d left) next.state
      | Error _ -> Scc_base.Bug.fail __POS__ "time passes beyond a movement step under laws of motion")
  | Some _ | None -> pass_within m d s
