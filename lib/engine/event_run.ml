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

(* What two may do that collide. *)
type pair = {
  sweeps : int * int;
  one : body;
  two : body;
  mutable ages : int * int;  (** when [collision] was found: again when one of them has changed *)
  mutable collision : Transition.outcome list;
}

module Firsts = Map.Make (Int)

module Pairs = Map.Make (struct
    type t = int * int

    let compare (a, b) (c, d) =
      let order = Int.compare a c in
      if order <> 0 then order else Int.compare b d
  end)

(* What may happen now. *)
type choice = Happens of Transition.outcome | Passes of Rat.t

type t = {
  semantics : Semantics.t;
  flights : Flights.t;
  agenda : event Heap.t;
  bodies : body option array;  (** by first leaf *)
  start_time : Rat.t option;
  mutable now : Rat.t;  (** since the start *)
  mutable ages : int;
  mutable colliding : pair Pairs.t;  (** of this instant, by first leaves *)
  mutable splitting : splits Firsts.t;  (** those at a split instant now, or with a strong split *)
  mutable choices : choice array option;  (** in the order of {!Network.successors} *)
  mutable room : int;  (** how many events to keep before those out of date are dropped *)
  mutable asked : Rat.t;  (** when {!changes} were asked for last *)
  mutable touched : bool Firsts.t;
  (** since then: the first leaves of those to whom something has happened, and whether there was a process of that
      first leaf then *)
}

let same_numbers (a, b) (c, d) = Int.equal a c && Int.equal b d
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

let renew t f = Flights.renew t.flights ~now:t.now f (watch t)

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
  Flights.drop t.flights b.flight;
  b.age <- -1;
  cannot_split t first;
  t.bodies.(first) <- None

let aged t b = Time.age_process (model t) (Rat.sub t.now b.since) b.process
let present t b = Turn.pass (model t) t.now (aged t b)

(* {1 Now} *)

let collide t (one : Flights.flight) (two : Flights.flight) =
  let key = (one.first, two.first) and sweeps = (one.sweep, two.sweep) in
  match Pairs.find_opt key t.colliding with
  | Some p when same_numbers p.sweeps sweeps -> ()
  | Some _ | None ->
    let one = body t one.first and two = body t two.first in
    t.colliding <- Pairs.add key { sweeps; one; two; ages = (-1, -1); collision = [] } t.colliding

let happen t event =
  match event with
  | Contact c -> collide t c.one c.two
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

let collision_now t p =
  let ages = (p.one.age, p.two.age) in
  if not (same_numbers p.ages ages) then begin
    p.collision <- Network.together t.semantics [| present t p.one; present t p.two |];
    p.ages <- ages
  end;
  p.collision

let on_course p = same_numbers p.sweeps (p.one.flight.sweep, p.two.flight.sweep)

(* Where collisions are resolved together, all who may collide now are looked at together (reading I-32). *)
let clusters_now t =
  let take p involved = Firsts.add p.one.flight.first p.one (Firsts.add p.two.flight.first p.two involved) in
  let involved = Pairs.fold (fun _ p found -> take p found) t.colliding Firsts.empty in
  Network.together t.semantics
    (Array.of_list (List.map (fun (_, b) -> present t b) (Firsts.bindings involved)))

let collisions_now t =
  let last_first all outcomes = List.rev_append outcomes all in
  match (model t).collisions with
  | In_turn -> Pairs.fold (fun _ p all -> last_first all (collision_now t p)) t.colliding []
  | Together -> List.rev (clusters_now t)

(* Whoever collides or splits now is involved, and rules look at nobody else. *)
let look t =
  come_up t;
  t.colliding <- Pairs.filter (fun _ p -> on_course p) t.colliding;
  let last_first all outcomes = List.rev_append outcomes all in
  let urgent, weak =
    Firsts.fold
      (fun _ s (urgent, weak) ->
         let more_urgent, more_weak = splits_now t s in
         (last_first urgent more_urgent, last_first weak more_weak))
      t.splitting ([], [])
  in
  let collisions = collisions_now t in
  let time () =
    match next_time t with
    | None -> []
    | Some next -> [ Passes (Rat.sub next t.now) ]
  in
  Network.in_order (fun o -> Happens o) { urgent; weak; collisions } ~time |> Array.of_list

let choices t =
  match t.choices with
  | Some choices -> choices
  | None ->
    let choices = look t in
    t.choices <- Some choices;
    choices

let passing t d = { label = Transition.Time d; rules = Network.time_rules t.semantics; rounded = None }

let alternatives t =
  let alternative = function
    | Happens o -> { label = o.label; rules = Transition.rules o; rounded = None }
    | Passes d -> passing t d
  in
  Array.to_list (Array.map alternative (choices t))

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
  let weak = function Happens { label = Transition.Weak_split _; _ } -> true | Happens _ | Passes _ -> false in
  let choices = choices t in
  match List.find_map (function Passes d -> Some d | Happens _ -> None) (Array.to_list choices) with
  | Some d -> Some (Some d)
  | None -> if Array.for_all weak choices && Option.is_none (next_time t) then Some None else None

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
  let choices = choices t in
  t.choices <- None;
  if i < 0 || i >= Array.length choices then Scc_base.Bug.fail __POS__ "an alternative that is not there";
  match choices.(i) with
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
  let semantics = Semantics.forgetful semantics in
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
      colliding = Pairs.empty;
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
