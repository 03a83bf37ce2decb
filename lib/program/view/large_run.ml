open Scc_base
open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_property
open Scc_runs

let large = 100
let is_for (m : Model.t) = Array.length m.leaves > large && Scc_engine.Run.inertial m

(* A process as it was at a time, since when it has only moved on. *)
type moving = { process : State.process; since : Rat.t }

type t = {
  world : States.world;
  state_after : int -> State.t;
  first : int;
  homes : moving option array;  (** by leaf; [None] once it is gone *)
  mutable last : int;
  mutable now : Rat.t;
  mutable told : Runs.taken list;
  mutable rest : Rat.t;
}

(* {1 Plots}

   Of numbers about a few processes, which are all that is looked at. *)

let leaves_of num =
  let compared : Property.temporal = State (Compare (Le, num, Const Rat.zero)) in
  if Formula.global compared || Formula.mentions_time compared then None else Some (Formula.leaves compared)

let none why = Curve_json.Whole (None_as why)

let value t extent num =
  match leaves_of num with
  | None -> none "it takes all bodies of a large network, and is not computed"
  | Some leaves when List.exists (fun leaf -> Option.is_none t.homes.(leaf)) leaves -> none "a body is gone"
  | Some leaves ->
    let m = Semantics.model (States.semantics t.world) in
    let present h = Turn.pass m (Rat.sub t.now h.since) h.process in
    let first (p : State.process) = p.leaves.(0).leaf in
    let add kept p = if List.exists (fun q -> first q = first p) kept then kept else p :: kept in
    let processes = List.filter_map (fun leaf -> Option.map present t.homes.(leaf)) leaves in
    let state = State.make ~processes:(List.fold_left add [] processes) ~step:None ~time:None in
    Curves.value (States.semantics t.world) state extent num

(* For what comes after it, which has taken so long. *)
let tell_values t d =
  let extent = if Rat.sign d > 0 then Scc_ctl.Timeline.Lasts d else Instant in
  match States.plots t.world with
  | [] -> ()
  | plots -> States.set_values t.world t.last (List.map (value t extent) plots)

(* {1 Steps} *)

let enter t since (p : State.process) =
  Array.iter (fun (l : State.leaf) -> t.homes.(l.leaf) <- Some { process = p; since }) p.leaves

let leave t first =
  let clear h = Array.iter (fun (l : State.leaf) -> t.homes.(l.leaf) <- None) h.process.State.leaves in
  Option.iter clear t.homes.(first)

let start world ~state_after (initial : State.t) =
  let leaves = Array.length (Semantics.model (States.semantics world)).leaves in
  let first = States.start world initial in
  let t =
    {
      world;
      state_after;
      first;
      homes = Array.make leaves None;
      last = first;
      now = Rat.zero;
      told = [];
      rest = Rat.zero;
    }
  in
  Array.iter (enter t Rat.zero) initial.processes;
  t

let step t (event : Replay.event) =
  match event with
  | Start _ | End _ -> ()
  | Instant { offset; _ } -> t.rest <- offset
  | Step { number; index; among; taken; changes; _ } ->
    let { Scc_engine.Event_run.gone; come } =
      match changes () with
      | Some c -> c
      | None -> Bug.fail __POS__ "a run that does not tell who has changed"
    in
    let d = Transition.duration_of taken.label in
    tell_values t d;
    t.now <- Rat.add t.now d;
    List.iter (leave t) gone;
    List.iter (enter t t.now) come;
    let target = States.changed t.world t.last d ~gone ~come (lazy (t.state_after number)) in
    let choice = if index < among then Some index else None in
    let label = States.label t.world taken.label in
    t.last <- target;
    t.told <- { choice; label; target; rules = taken.rules; tail = false } :: t.told

let run t ~name ~finish ~ending =
  tell_values t t.rest;
  let steps = List.rev t.told in
  Runs.run name None
    (Some { start = t.first; steps; rest = t.rest; finish; cycle = None; facts = []; argument = None; ending })
