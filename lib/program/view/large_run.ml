open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_property
open Scc_runs

let large = 100
let is_for (m : Model.t) = Array.length m.leaves > large && Scc_engine.Run.eventwise m

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
  mutable told_values : Curve_json.t list option;  (** of this instant, while no body changes *)
}

let model t = Semantics.model (States.semantics t.world)
let first (p : State.process) = p.leaves.(0).leaf
let present t h = Turn.pass (model t) (Rat.sub t.now h.since) h.process
let state_of processes = State.make ~processes ~step:None ~time:None

(* All processes as they are now. *)
let whole t =
  let begins leaf h = if first h.process = leaf then Some (present t h) else None in
  let at leaf h = Option.bind h (begins leaf) in
  state_of (List.filter_map Fun.id (Array.to_list (Array.mapi at t.homes)))

(* {1 Plots}

   Of numbers about a few processes, these are all that is looked at. A number about all of them is computed where
   bodies draw, as most steps are draws there, which change nothing. *)

type scope = Of of int list | Of_all | Unknown

let scope t num =
  let compared : Property.temporal = State (Compare (Le, num, Const Rat.zero)) in
  if Formula.mentions_time compared then Unknown
  else if not (Formula.global compared) then Of (Formula.leaves compared)
  else if Scc_engine.Run.inertial (model t) then Unknown
  else Of_all

let none why = Curve_json.Whole (None_as why)

let value t all extent num =
  let value state = Curves.value (States.semantics t.world) state extent num in
  match scope t num with
  | Unknown -> none "it takes all bodies of a large network, and is not computed: choose a number of some bodies"
  | Of leaves ->
    (* Of a body that is gone, the number says so itself. *)
    let add kept p = if List.exists (fun q -> first q = first p) kept then kept else p :: kept in
    let processes = List.filter_map (fun leaf -> Option.map (present t) t.homes.(leaf)) leaves in
    value (state_of (List.fold_left add [] processes))
  | Of_all -> value (Lazy.force all)

let values t extent =
  let all = lazy (whole t) in
  List.map (value t all extent) (States.plots t.world)

let values_now t =
  match t.told_values with
  | Some values -> values
  | None ->
    let values = values t Instant in
    t.told_values <- Some values;
    values

(* For what comes after it. The state in which the run begins may be one of another run, which has told of it how
   it goes on as long as it can. *)
let tell_values t (extent : Scc_ctl.Timeline.extent) =
  match States.plots t.world with
  | [] -> ()
  | _ :: _ ->
    States.set_values t.world t.last (fun () ->
        match extent with
        | Lasts d when Rat.sign d > 0 -> values t extent
        | Instant | Lasts _ -> values_now t
        | Forever -> values t Forever)

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
      told_values = None;
    }
  in
  Array.iter (enter t Rat.zero) initial.processes;
  t

(* Where laws have no value, a run goes on state by state. *)
let compared t d state =
  let gone, come = States.changes (model t) d (whole t) state in
  { Scc_engine.Event_run.gone; come }

let step t (event : Replay.event) =
  match event with
  | Start _ | End _ -> ()
  | Instant { offset; _ } -> t.rest <- offset
  | Step { number; index; among; taken; changes; state; _ } ->
    let d = Transition.duration_of taken.label in
    let { Scc_engine.Event_run.gone; come } =
      match changes () with Some c -> c | None -> compared t d (state ())
    in
    tell_values t (Lasts d);
    if Rat.sign d > 0 || gone <> [] || come <> [] then t.told_values <- None;
    t.now <- Rat.add t.now d;
    List.iter (leave t) gone;
    List.iter (enter t t.now) come;
    let target = States.changed t.world t.last d ~gone ~come (lazy (t.state_after number)) in
    let choice = if index < among then Some index else None in
    let label = States.label t.world taken.label in
    t.last <- target;
    t.told <- { choice; label; target; rules = taken.rules; tail = false } :: t.told

(* {1 The end} *)

(* Where nothing happens any more, the run is looked at for a while. No body turns in such a network
   ([Scc_engine.Run.eventwise]), so that nothing is told of that time but how long it is. *)
let look_on ?until t =
  tell_values t Forever;
  States.rest t.world t.last;
  let wanted =
    match until with
    | Some time -> Rat.sub time t.now
    | None -> Runs.a_while (States.semantics t.world) ~over:t.now (whole t)
  in
  t.rest <- Rat.max t.rest wanted

let run ?until t ~name ~finish ~ending =
  if String.equal finish "quiescent" then look_on ?until t else tell_values t (Lasts t.rest);
  let steps = List.rev t.told in
  Runs.run name None
    (Some { start = t.first; steps; rest = t.rest; finish; cycle = None; facts = []; argument = None; ending })
