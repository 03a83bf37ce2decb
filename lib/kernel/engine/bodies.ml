open Scc_data
open Scc_exact
open Scc_calculus
open Scc_semantics

(* A process now: as it was at the time [since], but for its positions, which are those of its line. *)
type body = {
  mutable process : State.process;
  mutable since : Rat.t;
  mutable age : int;  (** changes with [since]; -1 once the process has gone *)
  mutable seen : int;  (** changes whenever the process does, but for its place *)
  mutable waits : bool;  (** an eps of it runs down *)
  mutable shown : (Rat.t * State.process * State.process) option;
  (** a time at which the process has been asked for, [process] then, and what it was *)
  is_steered : bool;  (** a law moves it *)
  flight : Flights.flight;
}

(* What one process may do now: found when it is asked for. *)
type splits = {
  body : body;
  mutable found : (Transition.outcome list * Transition.outcome list) option;  (** strong and weak *)
}

module Firsts = Map.Make (Int)
module First_set = Set.Make (Int)

(* Of a first leaf to which something has happened: whether it was that of a process before. *)
type touch = Untouched | Was_there | Was_not_there

type t = {
  semantics : Semantics.t;
  flights : Flights.t;
  agenda : body Agenda.t;
  bodies : body option array;  (** by first leaf *)
  homes : int array;  (** by leaf: the first leaf of the process that had it last *)
  mutable frame : State.t;  (** the movement step and the absolute time now, without processes *)
  mutable steered : int;  (** how many bodies laws move *)
  mutable turns : Rat.t option;  (** the end of the movement step *)
  mutable now : Rat.t;  (** since the start *)
  mutable ages : int;
  colliding : (body, Transition.outcome) Colliding.t;  (** now, and since they met *)
  mutable splitting : splits Firsts.t;  (** those at a split instant now, or with a strong split *)
  mutable pending : First_set.t;  (** those at which lots are pending, once they have come up *)
  mutable asked : Rat.t;  (** when {!changes} were asked for last *)
  mutable touched : int list;  (** since then: the first leaves of those to whom something has happened *)
  touch : touch array;  (** by first leaf *)
}

let now t = t.now
let model t = Semantics.model t.semantics
let step t = t.frame.step
let frame t = t.frame

let end_of now (step : State.step option) =
  match step with
  | Some { remaining; _ } when Rat.sign remaining > 0 -> Some (Rat.add now remaining)
  | Some _ | None -> None

let set_step t step =
  t.turns <- end_of t.now step;
  t.frame <- State.at ~step ~time:t.frame.time t.frame

let any_steered t = t.steered > 0
let work t = Flights.work t.flights

(* When the velocity of a body is likely to change: at the end of the step, if it draws. *)
let turns t ~is_steered =
  match t.turns with
  | Some time when is_steered && Model.draws (model t) && Rat.compare time t.now >= 0 -> t.turns
  | Some _ | None -> None

let body t first =
  match t.bodies.(first) with
  | Some b -> b
  | None -> Scc_base.Bug.fail __POS__ "no process begins with this leaf"

let flight_turns t (f : Flights.flight) = turns t ~is_steered:(body t f.first).is_steered

let renew t flights =
  List.iter (fun (f : Flights.flight) -> Colliding.part t.colliding f.first) flights;
  Flights.renew t.flights ~now:t.now ~turns:(flight_turns t) flights (Agenda.watch t.agenda)

(* {1 Processes that come, age and go} *)

(* Where a process that is somewhere now would have been at the start, on its line. *)
let line t p = Turn.pass (model t) (Rat.neg t.now) p

let may_split t b = t.splitting <- Firsts.add b.flight.first { body = b; found = None } t.splitting
let cannot_split t first = t.splitting <- Firsts.remove first t.splitting

let touch t first =
  match t.touch.(first) with
  | Was_there | Was_not_there -> ()
  | Untouched ->
    t.touch.(first) <- (if Option.is_some t.bodies.(first) then Was_there else Was_not_there);
    t.touched <- first :: t.touched

let note_pending t b =
  let change = if Lots.is_pending b.process then First_set.add else First_set.remove in
  t.pending <- change b.flight.first t.pending

(* What comes of the pairs of a process that has changed is to be found anew. *)
let see_anew t b =
  touch t b.flight.first;
  t.ages <- t.ages + 1;
  b.seen <- t.ages;
  Colliding.changed t.colliding b.flight.first;
  if (model t).lots then note_pending t b

(* For a process that is as it was just now. *)
let schedule t b =
  see_anew t b;
  let age = t.ages in
  b.since <- t.now;
  b.age <- age;
  cannot_split t b.flight.first;
  let p = b.process in
  let expires = Time.horizon (model t) p in
  b.waits <- Option.is_some expires;
  let horizon = Option.merge Rat.min expires (Lots.wait (model t) p) in
  Option.iter (fun h -> Agenda.add t.agenda (Horizon { time = Rat.add t.now h; body = b; age })) horizon;
  Option.iter
    (fun d -> Agenda.add t.agenda (Split_instant { time = Rat.add t.now d; body = b; age }))
    (Time.to_split_instant (model t) p);
  if Process.at_split_instant p || Network.urgent t.semantics p <> [] then may_split t b

let enter t (p : State.process) =
  let line = line t p in
  let is_steered = Process.steers (model t) p in
  let flight = Flights.launch t.flights ~now:t.now ~turns:(turns t ~is_steered) line (Agenda.watch t.agenda) in
  let b =
    { process = line; since = t.now; age = -1; seen = -1; waits = false; shown = None; is_steered; flight }
  in
  if b.is_steered then t.steered <- t.steered + 1;
  touch t flight.first;
  t.bodies.(flight.first) <- Some b;
  Array.iter (fun (l : State.leaf) -> t.homes.(l.leaf) <- flight.first) p.leaves;
  schedule t b

let velocity t first = (body t first).process.velocity

let leave t first =
  let b = body t first in
  touch t first;
  if b.is_steered then t.steered <- t.steered - 1;
  Colliding.part t.colliding first;
  Flights.drop t.flights b.flight;
  b.age <- -1;
  cannot_split t first;
  t.pending <- First_set.remove first t.pending;
  t.bodies.(first) <- None

let aged t b = Time.age_process (model t) (Rat.sub t.now b.since) b.process

(* Whole states share the processes of one instant. *)
let present t b =
  match b.shown with
  | Some (now, process, p) when now == t.now && process == b.process -> p
  | Some _ | None ->
    let p = Turn.pass (model t) t.now (aged t b) in
    b.shown <- Some (t.now, b.process, p);
    p

(* {1 Now} *)

let happen t event =
  match event with
  | Agenda.Contact { one; two; _ } -> Colliding.meet t.colliding (body t one.first) (body t two.first)
  | Sweep_ends { ends; _ } -> renew t (Agenda.ended t.agenda ends)
  | Horizon { body; _ } ->
    body.process <- aged t body;
    schedule t body
  | Split_instant { time; body; age } ->
    may_split t body;
    (match (model t).splits with
     | Every step -> Agenda.add t.agenda (Split_instant { time = Rat.add time step; body; age })
     | Any_time -> ())

(* Everything that the agenda has for this instant. *)
let rec come_up t =
  match Agenda.first t.agenda with
  | Some event when Rat.compare (Agenda.time event) t.now <= 0 ->
    Agenda.drop_first t.agenda;
    happen t event;
    come_up t
  | Some _ | None -> ()

(* When the movement step ends, if that changes a velocity. *)
let end_of_step t =
  if t.steered = 0 then None
  else Option.map (fun (step : State.step) -> Rat.add t.now step.remaining) t.frame.step

(* When the next event comes that is one of the calculus, if that is at the end of the step at the latest. The ends
   of sweeps are none: what a process sweeps next still begins now, where all others are, for nothing forces time
   to pass. *)
let rec next_time t =
  let is_later time = match end_of_step t with Some e -> Rat.compare time e > 0 | None -> false in
  match Agenda.first t.agenda with
  | None -> None
  | Some event when is_later (Agenda.time event) -> None
  | Some (Sweep_ends { ends; _ }) ->
    Agenda.drop_first t.agenda;
    renew t (Agenda.ended t.agenda ends);
    next_time t
  | Some ((Contact _ | Horizon _ | Split_instant _) as event) -> Some (Agenda.time event)

let splits_now t s =
  match s.found with
  | Some found -> found
  | None ->
    let p = present t s.body in
    let found = (Network.urgent t.semantics p, Network.weak t.semantics p) in
    s.found <- Some found;
    found

let splits t = List.map (fun (_, s) -> splits_now t s) (Firsts.bindings t.splitting)

let find t found = Colliding.find t.colliding (fun p q -> found (present t p) (present t q))
let collisions t = (Colliding.count t.colliding, Colliding.nth t.colliding)
let stopping t = List.map (fun first -> present t (body t first)) (Colliding.stopping t.colliding)

let involved t = List.map (present t) (Colliding.bodies t.colliding)

let all t which =
  let add all b = if which b then present t b :: all else all in
  List.rev (Array.fold_left (fun all b -> Option.fold ~none:all ~some:(add all) b) [] t.bodies)

let with_leaves t leaves =
  let home leaf =
    let first = t.homes.(leaf) in
    let has b = State.has_leaf b.process leaf in
    if Option.fold ~none:false ~some:has t.bodies.(first) then Some first else None
  in
  let firsts = List.sort_uniq Int.compare (List.filter_map home leaves) in
  List.map (fun first -> present t (body t first)) firsts

let pending t = List.map (fun first -> present t (body t first)) (First_set.elements t.pending)

let decide t (p : State.process) =
  let b = body t p.leaves.(0).leaf in
  b.process <- State.with_lots p.lots b.process;
  see_anew t b

let steered t = all t (fun b -> b.is_steered)
let unsteered t = all t (fun b -> not b.is_steered)

(* {1 Steps} *)

let same_leaves (p : State.process) (q : State.process) =
  let same_leaf (l : State.leaf) (k : State.leaf) = l.leaf = k.leaf in
  Array.length p.leaves = Array.length q.leaves && Array.for_all2 same_leaf p.leaves q.leaves

let same_course (p : State.process) (q : State.process) = Vec.equal p.velocity q.velocity && same_leaves p q

(* Who goes on as before needs no new flight: a wall has as many neighbours as it is long. What may happen to it is
   found anew only if it is not as it was. *)
let go_on t (p : State.process) =
  let b = body t p.leaves.(0).leaf in
  if State.equal_process p (present t b) then touch t b.flight.first
  else begin
    b.process <- line t p;
    schedule t b
  end

(* All change at once: nobody is met on a course that is over. *)
let turn_all t processes =
  let turned (p : State.process) =
    let b = body t p.leaves.(0).leaf in
    Colliding.part t.colliding b.flight.first;
    b.process <- line t p;
    b
  in
  let turned = List.map turned processes in
  let lines = List.map (fun b -> (b.flight, b.process)) turned in
  Flights.turn t.flights ~now:t.now ~turns:(flight_turns t) lines (Agenda.watch t.agenda);
  List.iter (schedule t) turned

let turn t processes =
  let goes_on (p : State.process) = Vec.equal p.velocity (velocity t p.leaves.(0).leaf) in
  turn_all t (List.filter (fun p -> not (goes_on p)) processes)

(* One transition may release bonds of many processes (rule Lot). *)
let among same processes =
  let add all (p : State.process) = Firsts.add p.leaves.(0).leaf p all in
  let by_first = List.fold_left add Firsts.empty processes in
  fun (p : State.process) ->
    Option.fold ~none:false ~some:(same p) (Firsts.find_opt p.leaves.(0).leaf by_first)

let change t (o : Transition.outcome) =
  let was_there = among same_leaves o.gone and stays = among same_leaves o.come in
  let goes_on = among same_course o.gone in
  List.iter (fun (p : State.process) -> if not (stays p) then leave t p.leaves.(0).leaf) o.gone;
  turn_all t (List.filter (fun p -> was_there p && not (goes_on p)) o.come);
  List.iter (fun p -> if goes_on p then go_on t p else if not (was_there p) then enter t p) o.come

(* Nothing collides when time passes. *)
let pass t d =
  t.now <- Rat.add t.now d;
  t.frame <- Time.pass t.semantics d t.frame;
  t.splitting <-
    (match (model t).splits with
     | Every _ -> Firsts.empty
     | Any_time -> Firsts.map (fun s -> { s with found = None }) t.splitting)

(* {1 Changes} *)

type changes = { gone : int list; come : State.process list }

let forget_touched t =
  List.iter (fun first -> t.touch.(first) <- Untouched) t.touched;
  t.touched <- []

let changes t =
  if Rat.compare t.asked t.now < 0 then
    Array.iter (Option.iter (fun b -> if b.waits then touch t b.flight.first)) t.bodies;
  let touched = List.sort Int.compare t.touched in
  let gone first = match t.touch.(first) with Was_there -> Some first | Was_not_there | Untouched -> None in
  let come first = Option.map (present t) t.bodies.(first) in
  let changes = { gone = List.filter_map gone touched; come = List.filter_map come touched } in
  t.asked <- t.now;
  forget_touched t;
  changes

let start semantics ~step (s : State.t) =
  let leaves = Array.length (Semantics.model semantics).leaves in
  let t =
    {
      semantics;
      flights = Flights.create semantics;
      agenda = Agenda.create ~age:(fun b -> b.age);
      bodies = Array.make leaves None;
      homes = Array.init leaves Fun.id;
      frame = State.make ~processes:[] ~step ~time:s.time;
      steered = 0;
      turns = end_of Rat.zero step;
      now = Rat.zero;
      ages = 0;
      colliding = Colliding.create leaves ~first:(fun b -> b.flight.first) ~age:(fun b -> b.seen);
      splitting = Firsts.empty;
      pending = First_set.empty;
      asked = Rat.zero;
      touched = [];
      touch = Array.make leaves Untouched;
    }
  in
  Spread.iter (fun p -> enter t (State.with_draw None p)) s.processes;
  forget_touched t;
  t
