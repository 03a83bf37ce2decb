open Scc_data
open Scc_exact
open Scc_calculus
open Scc_semantics

(* A process now: as it was at the time [since], but for its positions, which are those of its line. *)
type body = {
  mutable process : State.process;
  mutable since : Rat.t;
  mutable age : int;  (** changes with [since]; -1 once the process has gone *)
  mutable waits : bool;  (** an eps of it runs down *)
  flight : Flights.flight;
}

(* Events to come. Those whose numbers are out of date are dropped when their time comes. *)
type event =
  | Contact of {
      time : Rat.t;
      one : Flights.flight;
      two : Flights.flight;
      sweep_one : int;
      sweep_two : int;
    }
  | Sweep_end of { time : Rat.t; flight : Flights.flight; sweep : int }
  | Horizon of { time : Rat.t; body : body; age : int }  (** an eps expires *)
  | Split_instant of { time : Rat.t; body : body; age : int }

type alternative = {
  label : Transition.label;
  rules : Rule.t list;
  rounded : Totals.t Lazy.t option;
}

(* What one process may do now: found when it is asked for. *)
type splits = {
  body : body;
  mutable found : (Transition.outcome list * Transition.outcome list) option;  (** strong and weak *)
}

module Firsts = Map.Make (Int)

(* What may happen now; collisions by their number, as there may be thousands at one instant, of which each that
   happens leaves most as they were. *)
type choices = {
  urgent : Transition.outcome array;
  weak : Transition.outcome array;
  collisions : int;
  collision : int -> Transition.outcome;
  passes : Rat.t option;
}

type choice = Happens of Transition.outcome | Passes of Rat.t

type t = {
  semantics : Semantics.t;
  flights : Flights.t;
  agenda : event Heap.t;
  bodies : body option array;  (** by first leaf *)
  start_time : Rat.t option;
  mutable now : Rat.t;  (** since the start *)
  mutable ages : int;
  colliding : (body, Transition.outcome) Colliding.t;  (** now, and since they met *)
  mutable splitting : splits Firsts.t;  (** those at a split instant now, or with a strong split *)
  mutable choices : choices option;
  mutable room : int;  (** how many events to keep before those out of date are dropped *)
  mutable asked : Rat.t;  (** when {!changes} were asked for last *)
  mutable touched : bool Firsts.t;
  (** since then: the first leaves of those to whom something has happened, and whether there was a process of that
      first leaf then *)
}

let elapsed t = t.now
let model t = Semantics.model t.semantics
let work t = Flights.work t.flights

(* {1 The agenda} *)

let valid = function
  | Contact c -> c.one.sweep = c.sweep_one && c.two.sweep = c.sweep_two
  | Sweep_end s -> s.flight.sweep = s.sweep
  | Horizon { body; age; _ } | Split_instant { body; age; _ } -> body.age = age

let time_of = function
  | Contact { time; _ } | Sweep_end { time; _ } | Horizon { time; _ } | Split_instant { time; _ } -> time

let by_time d e = Rat.compare (time_of d) (time_of e)
let least_room = 1024

let add t event =
  if Heap.size t.agenda >= t.room then begin
    Heap.keep t.agenda valid;
    t.room <- Int.max least_room (2 * Heap.size t.agenda)
  end;
  Heap.add t.agenda event

let watch t : Flights.watch =
  {
    contact =
      (fun time one two ->
         add t (Contact { time; one; two; sweep_one = one.sweep; sweep_two = two.sweep }));
    sweep_end = (fun time flight -> add t (Sweep_end { time; flight; sweep = flight.sweep }));
  }

let renew t f =
  Colliding.part t.colliding f.Flights.first;
  Flights.renew t.flights ~now:t.now f (watch t)

(* {1 Processes that come, age and go} *)

(* Where a process that is somewhere now would have been at the start, on its line. *)
let line t p = Turn.pass (model t) (Rat.neg t.now) p

let may_split t b = t.splitting <- Firsts.add b.flight.first { body = b; found = None } t.splitting
let cannot_split t first = t.splitting <- Firsts.remove first t.splitting

let touch t first =
  if not (Firsts.mem first t.touched) then
    t.touched <- Firsts.add first (Option.is_some t.bodies.(first)) t.touched

(* For a process that is as it was just now. *)
let schedule t b =
  touch t b.flight.first;
  t.ages <- t.ages + 1;
  let age = t.ages in
  b.since <- t.now;
  b.age <- age;
  cannot_split t b.flight.first;
  Colliding.changed t.colliding b.flight.first;
  let p = b.process in
  let horizon = Time.horizon (model t) p in
  b.waits <- Option.is_some horizon;
  Option.iter (fun h -> add t (Horizon { time = Rat.add t.now h; body = b; age })) horizon;
  Option.iter
    (fun d -> add t (Split_instant { time = Rat.add t.now d; body = b; age }))
    (Time.to_split_instant (model t) p);
  if Process.at_split_instant p || Network.urgent t.semantics p <> [] then may_split t b

let enter t (p : State.process) =
  let line = line t p in
  let flight = Flights.launch t.flights ~now:t.now line (watch t) in
  let b = { process = line; since = t.now; age = -1; waits = false; flight } in
  touch t flight.first;
  t.bodies.(flight.first) <- Some b;
  schedule t b

let body t first =
  match t.bodies.(first) with
  | Some b -> b
  | None -> Scc_base.Bug.fail __POS__ "no process begins with this leaf"

let velocity t first = (body t first).process.velocity

let leave t first =
  let b = body t first in
  touch t first;
  Colliding.part t.colliding first;
  Flights.drop t.flights b.flight;
  b.age <- -1;
  cannot_split t first;
  t.bodies.(first) <- None

let aged t b = Time.age_process (model t) (Rat.sub t.now b.since) b.process
let present t b = Turn.pass (model t) t.now (aged t b)

(* {1 Now} *)

let happen t event =
  match event with
  | Contact c -> Colliding.meet t.colliding (body t c.one.first) (body t c.two.first)
  | Sweep_end s -> renew t s.flight
  | Horizon { body; _ } ->
    body.process <- aged t body;
    schedule t body
  | Split_instant { time; body; age } ->
    may_split t body;
    (match (model t).splits with
     | Every step -> add t (Split_instant { time = Rat.add time step; body; age })
     | Any_time -> ())

(* Everything that the agenda has for this instant. *)
let rec come_up t =
  match Heap.first t.agenda with
  | Some event when not (valid event) || Rat.compare (time_of event) t.now <= 0 ->
    Heap.drop_first t.agenda;
    if valid event then happen t event;
    come_up t
  | Some _ | None -> ()

(* When the next event comes that is one of the calculus. The ends of sweeps are none: what a process sweeps next
   still begins now, where all others are, for nothing forces time to pass. *)
let rec next_time t =
  match Heap.first t.agenda with
  | None -> None
  | Some event ->
    if not (valid event) then begin
      Heap.drop_first t.agenda;
      next_time t
    end
    else begin
      match event with
      | Sweep_end s ->
        Heap.drop_first t.agenda;
        renew t s.flight;
        next_time t
      | Contact _ | Horizon _ | Split_instant _ -> Some (time_of event)
    end

let splits_now t s =
  match s.found with
  | Some found -> found
  | None ->
    let p = present t s.body in
    let found = (Network.urgent t.semantics p, Network.weak t.semantics p) in
    s.found <- Some found;
    found

(* How many collisions may happen now, and each by its number. Where they are resolved together, all who may
   collide are looked at together (reading I-32). *)
let collisions_now t =
  match (model t).collisions with
  | In_turn ->
    Colliding.find t.colliding (fun p q -> Network.together t.semantics [| present t p; present t q |]);
    (Colliding.count t.colliding, Colliding.nth t.colliding)
  | Together ->
    let involved = List.map (present t) (Colliding.bodies t.colliding) in
    let collisions = Array.of_list (Network.together t.semantics (Array.of_list involved)) in
    (Array.length collisions, Array.get collisions)

(* Whoever collides or splits now is involved, and rules look at nobody else. *)
let look t =
  come_up t;
  let splits = List.map (fun (_, s) -> splits_now t s) (Firsts.bindings t.splitting) in
  let all kind = Array.of_list (List.concat_map kind splits) in
  let collisions, collision = collisions_now t in
  let urgent = all fst in
  let passes =
    if Array.length urgent > 0 || collisions > 0 then None
    else Option.map (fun next -> Rat.sub next t.now) (next_time t)
  in
  { urgent; weak = all snd; collisions; collision; passes }

let choices t =
  match t.choices with
  | Some choices -> choices
  | None ->
    let choices = look t in
    t.choices <- Some choices;
    choices

let discrete c = Array.length c.urgent + Array.length c.weak + c.collisions

let count t =
  let c = choices t in
  discrete c + if Option.is_some c.passes then 1 else 0

(* In the order of {!Network.in_order}. *)
let choice t i =
  let c = choices t in
  let urgent = Array.length c.urgent and weak = Array.length c.weak in
  match c.passes with
  | Some d when i = discrete c -> Passes d
  | Some _ | None ->
    if i < 0 || i >= discrete c then Scc_base.Bug.fail __POS__ "an alternative that is not there"
    else if i < urgent then Happens c.urgent.(i)
    else if i < urgent + weak then Happens c.weak.(i - urgent)
    else Happens (c.collision (i - urgent - weak))

let label t i = match choice t i with Happens o -> o.label | Passes d -> Transition.Time d

let passing t d = { label = Transition.Time d; rules = Network.time_rules t.semantics; rounded = None }

let alternative t i =
  match choice t i with
  | Happens o -> { label = o.label; rules = Transition.rules o; rounded = None }
  | Passes d -> passing t d

(* {1 Steps} *)

(* Nothing collides when time passes. *)
let pass t d =
  t.now <- Rat.add t.now d;
  t.splitting <-
    (match (model t).splits with
     | Every _ -> Firsts.empty
     | Any_time -> Firsts.map (fun s -> { s with found = None }) t.splitting)

(* How long time may pass, at most; [Some None] for ever. *)
let room t =
  let c = choices t in
  match c.passes with
  | Some d -> Some (Some d)
  | None -> if Array.length c.urgent = 0 && c.collisions = 0 then Some None else None

let wait t d =
  let may =
    match ((model t).splits, room t) with
    | Every _, _ | Any_time, None -> false
    | Any_time, Some greatest ->
      Rat.sign d > 0 && Option.fold ~none:true ~some:(fun most -> Rat.compare d most < 0) greatest
  in
  if not may then None
  else begin
    t.choices <- None;
    pass t d;
    Some (passing t d)
  end

let same_course (p : State.process) (q : State.process) =
  let same_leaf (l : State.leaf) (k : State.leaf) = l.leaf = k.leaf in
  Vec.equal p.velocity q.velocity
  && Array.length p.leaves = Array.length q.leaves
  && Array.for_all2 same_leaf p.leaves q.leaves

(* Who goes on as before needs no new flight: a wall has as many neighbours as it is long. *)
let go_on t (p : State.process) =
  let b = body t p.leaves.(0).leaf in
  b.process <- line t p;
  schedule t b

let change t (o : Transition.outcome) =
  let goes_on p = List.exists (same_course p) o.gone and stays q = List.exists (same_course q) o.come in
  List.iter (fun (p : State.process) -> if not (stays p) then leave t p.leaves.(0).leaf) o.gone;
  List.iter (fun p -> if goes_on p then go_on t p else enter t p) o.come

let take t i =
  let taken = choice t i in
  t.choices <- None;
  match taken with
  | Happens o -> change t o
  | Passes d -> pass t d

let state t =
  let present_body processes = function
    | None -> processes
    | Some b -> present t b :: processes
  in
  State.make
    ~processes:(List.rev (Array.fold_left present_body [] t.bodies))
    ~step:None
    ~time:(Option.map (Rat.add t.now) t.start_time)

type changes = { gone : int list; come : State.process list }

let changes t =
  if Rat.compare t.asked t.now < 0 then
    Array.iter (Option.iter (fun b -> if b.waits then touch t b.flight.first)) t.bodies;
  let touched = Firsts.bindings t.touched in
  t.asked <- t.now;
  t.touched <- Firsts.empty;
  let gone (first, was_there) = if was_there then Some first else None in
  let come (first, _) = Option.map (present t) t.bodies.(first) in
  { gone = List.filter_map gone touched; come = List.filter_map come touched }

(* Bodies that come to touch and do not collide are on no agenda (reading I-33). *)
let can_run m = Model.straight m && not (Model.binds_on_contact m)

let start semantics (s : State.t) =
  (* Whoever is asked about twice at one instant is kept here, and in the next one all are others. *)
  let semantics = Semantics.without_memo semantics in
  let m = Semantics.model semantics in
  if not (can_run m) then Scc_base.Bug.fail __POS__ "a model whose runs go step by step";
  let t =
    {
      semantics;
      flights = Flights.create semantics;
      agenda = Heap.create ~near:(fun e -> Rat.to_float (time_of e)) ~compare:by_time;
      bodies = Array.make (Array.length m.leaves) None;
      start_time = s.time;
      now = Rat.zero;
      ages = 0;
      colliding =
        Colliding.create (Array.length m.leaves) ~first:(fun b -> b.flight.first) ~age:(fun b -> b.age);
      splitting = Firsts.empty;
      choices = None;
      room = least_room;
      asked = Rat.zero;
      touched = Firsts.empty;
    }
  in
  Spread.iter (enter t) s.processes;
  t.touched <- Firsts.empty;
  t
