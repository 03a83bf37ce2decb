open Scc_exact
open Scc_calculus
open Scc_semantics

type alternative = {
  label : Transition.label;
  rules : Rule.t list;
  rounded : Totals.t Lazy.t option;
  replaced : (State.process list * State.process list) option;
}

(* What may happen now; collisions by their number, as there may be thousands at one instant, of which each that
   happens leaves most as they were. *)
type choices = {
  urgent : Transition.outcome array;
  weak : Transition.outcome array;
  collisions : int;
  collision : int -> Transition.outcome;
  passes : Rat.t option;
}

type choice = Drawn of int | Happens of Transition.outcome | Collides of Transition.outcome | Passes of Rat.t

type t = {
  semantics : Semantics.t;
  bodies : Bodies.t;
  mutable draws : Draws.t option;  (** of the steered bodies, while one of them waits to draw *)
  mutable lots : Lot_queue.t option;  (** while lots are pending *)
  mutable doubtful : bool;  (** laws of a process that is there, or may come to be, may have no value *)
  mutable choices : choices option;
}

let elapsed t = Bodies.now t.bodies
let semantics t = t.semantics
let model t = Semantics.model t.semantics
let work t = Bodies.work t.bodies
let velocity t first = Bodies.velocity t.bodies first

(* {1 Laws that may have no value}

   The model's laws have values ({!can_run}), but those of the leaves of one process may be too many together. *)

let combinations (m : Model.t) (p : State.process) =
  let kicks (l : State.leaf) = match m.leaves.(l.leaf).law with Choose all -> List.length all | _ -> 1 in
  let times product l = Int.min (product * kicks l) (Law.most_outcomes + 1) in
  Array.fold_left times 1 p.leaves

let doubt t (p : State.process) =
  let m = model t in
  if Model.draws m && Array.length p.leaves > 1 && combinations m p > Law.most_outcomes then
    t.doubtful <- t.doubtful || Result.is_error (Steer.chances t.semantics (Bodies.frame t.bodies) p)

let doubt_all t outcomes =
  if Model.draws (model t) then List.iter (fun (o : Transition.outcome) -> List.iter (doubt t) o.come) outcomes;
  outcomes

(* {1 Now} *)

let together t processes = doubt_all t (Network.together t.semantics processes)

(* A pair of which nothing comes may stop walkers; a bond or an absorption comes first. *)
let found t p q =
  let outcomes = together t [| p; q |] in
  let comes_first (o : Transition.outcome) =
    match o.label with Bounce _ -> false | _ -> true
  in
  let stopping = if outcomes = [] then Blocked.stopping t.semantics [| p; q |] else [] in
  let first (p : State.process) = p.leaves.(0).leaf in
  { Colliding.outcomes; busy = List.exists comes_first outcomes; stops = List.map first stopping }

(* How many collisions may happen now, and each by its number. Where they are resolved together, all who may
   collide are looked at together (reading I-32). *)
let collisions_now t =
  match (model t).collisions with
  | In_turn | Drawn ->
    Bodies.find t.bodies (found t);
    Bodies.collisions t.bodies
  | Together ->
    let collisions = Array.of_list (together t (Array.of_list (Bodies.involved t.bodies))) in
    (Array.length collisions, Array.get collisions)

(* How far time passes where nothing is urgent. *)
let delay t =
  let next = Option.map (fun next -> Rat.sub next (elapsed t)) (Bodies.next_time t.bodies) in
  match (next, Bodies.step t.bodies) with
  | Some d, Some step -> Some (Rat.min d step.remaining)
  | None, Some step when Bodies.any_steered t.bodies -> Some step.remaining
  | _, _ -> next

(* Where chances sum to more than 1, the rules alone say what is reported. *)
let of_lots t lots =
  let outcomes =
    match Splits.lots t.semantics (Lot_queue.due lots) with
    | Ok outcomes -> outcomes
    | Error _ ->
      t.doubtful <- true;
      []
  in
  let none _ = Scc_base.Bug.fail __POS__ "a collision while lots are pending" in
  { urgent = Array.of_list outcomes; weak = [||]; collisions = 0; collision = none; passes = None }

(* Whoever collides or splits now is involved, and rules look at nobody else. *)
let look_around t =
  Bodies.come_up t.bodies;
  let splits = Bodies.splits t.bodies in
  let all kind = Array.of_list (List.concat_map kind splits) in
  let collisions, collision = collisions_now t in
  let urgent = all fst in
  let passes = if Array.length urgent > 0 || collisions > 0 then None else delay t in
  { urgent; weak = all snd; collisions; collision; passes }

let look t = match t.lots with Some lots -> of_lots t lots | None -> look_around t

let choices t =
  match t.choices with
  | Some choices -> choices
  | None ->
    let choices = look t in
    t.choices <- Some choices;
    choices

let discrete c = Array.length c.urgent + Array.length c.weak + c.collisions

let may_fail t =
  if Option.is_none t.draws then ignore (choices t);
  t.doubtful

let sure = function
  | Ok x -> x
  | Error _ -> Scc_base.Bug.fail __POS__ "laws that always have values"

let chances t draws = sure (Draws.chances t.semantics draws)

let count t =
  match t.draws with
  | Some draws -> Array.length (chances t draws)
  | None ->
    let c = choices t in
    discrete c + if Option.is_some c.passes then 1 else 0

(* In the order of {!Network.in_order}. *)
let event t i =
  let c = choices t in
  let urgent = Array.length c.urgent and weak = Array.length c.weak in
  match c.passes with
  | Some d when i = discrete c -> Passes d
  | Some _ | None ->
    if i < 0 || i >= discrete c then Scc_base.Bug.fail __POS__ "an alternative that is not there"
    else if i < urgent then Happens c.urgent.(i)
    else if i < urgent + weak then Happens c.weak.(i - urgent)
    else Collides (c.collision (i - urgent - weak))

let tie t =
  if Option.is_some t.draws || Option.is_some t.lots || not (Model.draws_ties (model t)) then None
  else
    let c = choices t in
    let urgent = Array.length c.urgent and weak = Array.length c.weak in
    let outcome k = if k < urgent then c.urgent.(k) else c.collision (k - urgent) in
    let deed k = Ties.deed (outcome k) in
    if urgent + c.collisions < 2 then None
    else
      let pick source =
        let k = Ties.pick source (urgent + c.collisions) deed in
        if k < urgent then k else k + weak
      in
      Some { Ties.others = List.init weak (fun k -> urgent + k); pick }

let choice t i = match t.draws with Some _ -> Drawn i | None -> event t i
let drawn_label draws chances i = Steer.draw_label (Draws.drawer draws) (Array.get chances i)

let label t i =
  match (t.draws, choice t i) with
  | Some draws, _ -> drawn_label draws (chances t draws) i
  | None, (Happens o | Collides o) -> o.label
  | None, Passes d -> Transition.Time d
  | None, Drawn _ -> Scc_base.Bug.fail __POS__ "a draw of nobody"

let chance t i = match t.draws with Some draws -> snd (chances t draws).(i) | None -> Transition.chance (label t i)

(* {1 Laws of motion}

   What is due after each transition, as {!Steer.settle} has it. *)

(* Walkers stop where they run into something, until none does ({!Blocked.stopped}). *)
let rec stop t =
  if Model.stops_walkers (model t) then begin
    Bodies.come_up t.bodies;
    Bodies.find t.bodies (found t);
    let stopping = Bodies.stopping t.bodies in
    if stopping <> [] then begin
      Bodies.turn t.bodies (List.map (State.with_velocity Vec.zero) stopping);
      stop t
    end
  end

(* A kick may be blocked by whoever is in its way. *)
let begin_steps t (asked : State.t) =
  let unsteered = match (model t).blocked with Wait -> Bodies.unsteered t.bodies | Bounce | Stop -> [] in
  let processes = List.rev_append unsteered (Array.to_list asked.processes) in
  let begun = Steer.kicked t.semantics (State.make ~processes ~step:asked.step ~time:asked.time) in
  Bodies.set_step t.bodies begun.step;
  Bodies.turn t.bodies (Array.to_list begun.processes);
  stop t;
  if Array.length asked.processes > 0 then Steer.rules else []

let steer t =
  let { State.step; time; _ } = Bodies.frame t.bodies in
  let steered = State.make ~processes:(Bodies.steered t.bodies) ~step ~time in
  let asked = sure (Steer.ask t.semantics ~which:(fun _ -> true) steered) in
  t.draws <- Draws.waiting t.semantics asked;
  if Option.is_some t.draws then [] else begin_steps t asked

let begin_lots t =
  t.lots <-
    (match Bodies.pending t.bodies with
     | [] -> None
     | _ :: _ as processes -> Some (Lot_queue.make (model t) processes))

let evaluate_laws t =
  match Bodies.step t.bodies with
  | Some { phase = Due; _ } ->
    Bodies.come_up t.bodies;
    if fst (collisions_now t) > 0 then [] else steer t
  | Some { phase = Moving | Steered; _ } | None -> []

(* Laws wait until no lots are pending. *)
let settle t =
  stop t;
  if (model t).lots then begin
    Bodies.come_up t.bodies;
    begin_lots t
  end;
  if Option.is_some t.lots then [] else evaluate_laws t

let taken ?(gone = []) ?(come = []) label rules = { label; rules; rounded = None; replaced = Some (gone, come) }

let draw t draws i =
  let chances = chances t draws in
  let label = drawn_label draws chances i in
  let rules =
    if not (Draws.draw draws (fst chances.(i))) then []
    else begin
      t.draws <- None;
      begin_steps t (Draws.state draws)
    end
  in
  taken label (Network.draw_rules @ rules)

let passed t d = taken (Transition.Time d) (Network.time_rules t.semantics @ settle t)
let happened t (o : Transition.outcome) =
  let rules = settle t in
  taken o.label (Transition.rules o @ rules) ~gone:o.gone ~come:o.come

(* Decisions change nothing but lots, so that no walker stops. *)
let decided t lots (o : Transition.outcome) =
  let p = List.hd o.come in
  Bodies.decide t.bodies p;
  Lot_queue.decide lots p;
  if Lot_queue.is_over lots then happened t o else taken o.label (Transition.rules o)

(* How long time may pass, at most; [Some None] for ever. *)
let room t =
  let c = choices t in
  match c.passes with
  | Some d -> Some (Some d)
  | None -> if Array.length c.urgent = 0 && c.collisions = 0 then Some None else None

let may_wait t d =
  match ((model t).splits, t.draws) with
  | Every _, _ | Any_time, Some _ -> false
  | Any_time, None ->
    let less greatest = Option.fold ~none:true ~some:(fun most -> Rat.compare d most < 0) greatest in
    Rat.sign d > 0 && Option.fold ~none:false ~some:less (room t)

let wait t d =
  if not (may_wait t d) then None
  else begin
    t.choices <- None;
    Bodies.pass t.bodies d;
    Some (passed t d)
  end

let take t i =
  let taken = choice t i in
  t.choices <- None;
  match (taken, t.draws, t.lots) with
  | Drawn i, Some draws, _ -> draw t draws i
  | Drawn _, None, _ -> Scc_base.Bug.fail __POS__ "a draw of nobody"
  | Happens ({ label = Lot _; _ } as o), _, Some lots -> decided t lots o
  | Happens o, _, _ ->
    Bodies.change t.bodies o;
    happened t o
  | Collides o, _, _ ->
    Bodies.change t.bodies o;
    Bodies.set_step t.bodies (Network.after_collision (model t) (Bodies.step t.bodies));
    happened t o
  | Passes d, _, _ ->
    Bodies.pass t.bodies d;
    passed t d

let draws_on t = Option.is_some t.draws || Option.fold ~none:false ~some:Lot_queue.draws t.lots

let state t =
  let { State.step; time; _ } = Bodies.frame t.bodies in
  let steered =
    match t.draws with
    | Some draws -> Array.to_list (Draws.state draws).processes
    | None -> Bodies.steered t.bodies
  in
  State.make ~processes:(Bodies.unsteered t.bodies @ steered) ~step ~time

let part t leaves =
  let processes = Bodies.with_leaves t.bodies leaves in
  let { State.step; time; _ } = Bodies.frame t.bodies in
  match t.draws with
  | Some draws -> State.at ~step ~time (Draws.drawn draws processes)
  | None -> State.make ~processes ~step ~time

type changes = Bodies.changes = { gone : int list; come : State.process list }

let changes t = Bodies.changes t.bodies

(* {1 Starts} *)

(* Bodies that come to touch and do not collide are on no agenda (reading I-33). *)
let can_run (m : Model.t) =
  let has_values (l : Model.leaf) = l.fixed || Law.never_fails l.law in
  (not (Model.of_each m || Model.has_turns m || Model.binds_on_contact m))
  && Array.for_all has_values m.leaves

(* From any state: also while bodies draw. *)
let resume_draws t (s : State.t) =
  let drawing = List.filter (fun (p : State.process) -> Option.is_some p.draw) (Array.to_list s.processes) in
  t.draws <- Draws.waiting t.semantics (State.make ~processes:drawing ~step:s.step ~time:s.time)

let start semantics (s : State.t) =
  (* Whoever is asked about twice at one instant is kept here, and in the next one all are others. *)
  let semantics = Semantics.without_memo semantics in
  let m = Semantics.model semantics in
  if not (can_run m) then Scc_base.Bug.fail __POS__ "a model whose runs go step by step";
  let steps = Model.of_all m in
  let bodies = Bodies.start semantics ~step:(if steps then s.step else None) s in
  let t = { semantics; bodies; draws = None; lots = None; doubtful = false; choices = None } in
  Array.iter (doubt t) s.processes;
  if steps then resume_draws t s;
  begin_lots t;
  t
