open Scc_exact
open Scc_calculus
open Scc_property
open Scc_semantics
open Scc_explore
module Engine = Engine.Make (System)
module Graph = Engine.Graph

type 'a bound = Unbounded | Default of 'a | Given of 'a

type options = {
  depth : int bound;
  time : Rat.t bound;
  states : int bound;
  seconds : float bound;
  memory : int bound;
  instant : int bound;
  surroundings : Limits.surroundings;
  observe : (State.t -> unit) option;
}

let default =
  {
    depth = Unbounded;
    time = Unbounded;
    states = Unbounded;
    seconds = Unbounded;
    memory = Unbounded;
    instant = Default 10_000;
    surroundings = Limits.quiet;
    observe = None;
  }

type outcome = Verdict of Verdict.t | Not_yet of string

type stats = {
  states : int;
  transitions : int;
  depth : int;
  model_time : Rat.t;
  complete : bool;
  eventful : bool;
  decided_early : bool;
  stopped_by : Verdict.truncation list;
  faults : string list;
}

type report = {
  outcomes : (Property.check * outcome) list;
  stats : stats;
  zeno : Witness.t option;
}

(** {2 Bounds} *)

let value = function Unbounded -> None | Default v | Given v -> Some v

let limits (o : options) : Limits.t =
  {
    depth = value o.depth;
    time = value o.time;
    instant = value o.instant;
    states = value o.states;
    seconds = value o.seconds;
    memory = value o.memory;
  }

let truncation bound make : Verdict.truncation =
  match bound with
  | Given v -> { limit = make v; origin = By_user }
  | Default v -> { limit = make v; origin = By_default }
  | Unbounded -> Scc_base.Bug.fail __POS__ "a bound that is off was met"

(* The bound of time is the properties' own when theirs is the lesser. *)
let time_truncation (o : options) horizon : Verdict.truncation =
  match (horizon, value o.time) with
  | Some h, Some t when Rat.equal h t -> truncation o.time (fun t -> Verdict.Time t)
  | Some h, _ -> { limit = Time h; origin = By_property }
  | None, _ -> truncation o.time (fun t -> Verdict.Time t)

type cause = Bound of Verdict.truncation | Fault of string | Early

let cause (o : options) model horizon (r : _ Explore.reason) =
  match r with
  | Depth -> Bound (truncation o.depth (fun n -> Verdict.Depth n))
  | Time -> Bound (time_truncation o horizon)
  | Instant -> Bound (truncation o.instant (fun n -> Verdict.Instant n))
  | States -> Bound (truncation o.states (fun n -> Verdict.States n))
  | Seconds -> Bound (truncation o.seconds (fun s -> Verdict.Seconds s))
  | Memory -> Bound (truncation o.memory (fun w -> Verdict.Memory w))
  | Interrupted -> Bound { limit = Interrupted; origin = By_user }
  | Stopped -> Early
  | Fault f -> Fault (Transition.fault_to_string model f)

(** {2 Witnesses} *)

type run = {
  options : options;
  model : Model.t;
  context : System.context;
  graph : Graph.t;
  horizon : Rat.t option;
}

let state r i = Catalogue.decode (System.catalogue r.context) (Graph.tuple r.graph i)
let label r (e : Graph.edge) = Catalogue.label_of (System.catalogue r.context) e.label

(* A witness is followed through the successors afresh before anyone is shown it. *)
let replayed r (trace : Engine.trace) =
  let choices = List.map (fun (s : Graph.step) -> s.choice) trace.steps in
  let initial = System.start r.context in
  match Network.follow r.model initial choices with
  | Error _ -> Scc_base.Bug.fail __POS__ "a witness does not replay"
  | Ok transitions ->
    let last = match List.rev transitions with [] -> initial | t :: _ -> t.Transition.target in
    if not (State.equal last (state r trace.last)) then
      Scc_base.Bug.fail __POS__ "a witness replays to another state";
    let step (time, acc) choice transition =
      let time = Rat.add time (Transition.duration transition) in
      (time, { Witness.choice; transition; time } :: acc)
    in
    let _, steps = List.fold_left2 step (Rat.zero, []) choices transitions in
    List.rev steps

let rec drop n l = match l with _ :: rest when n > 0 -> drop (n - 1) rest | _ -> l

(* A weak split that is enabled somewhere on a cycle and never made on it. *)
let puts_off r (cycle : Graph.step list) =
  let made =
    List.map (fun (s : Graph.step) -> label r (Graph.edges r.graph s.source).(s.choice)) cycle
  in
  let is_put_off (e : Graph.edge) =
    match label r e with
    | Weak_split _ as l when not (List.exists (Transition.equal_label l) made) -> Some l
    | Weak_split _ | Time _ | Bind _ | Bounce _ | Strong_split _ -> None
  in
  List.find_map
    (fun (s : Graph.step) ->
       List.find_map is_put_off (Array.to_list (Graph.edges r.graph s.source)))
    cycle

let finish r (trace : Engine.trace) : Witness.finish =
  match trace.finish with
  | At_state -> At_state
  | Rests -> Rests
  | Stops -> Stops
  | Passes choice -> Passes { choice }
  | Repeats cycle -> Repeats { cycle; puts_off = puts_off r (drop cycle trace.steps) }
  | During { choice; moment; sample } ->
    During
      { choice; offset = sample; open_piece = not moment.attained; from = moment.offset }

let facts r (trace : Engine.trace) p =
  let state = state r trace.last in
  match trace.finish with
  | At_state | Rests | Stops | Repeats _ | Passes _ ->
    Explain.facts r.model state Timeline.Instant Algebraic.zero p
  | During { choice; sample; _ } ->
    let extent =
      match choice with
      | None -> Timeline.Forever
      | Some k ->
        Lasts (Graph.duration r.graph (Graph.edges r.graph trace.last).(k))
    in
    Explain.facts r.model state extent sample p

let witness r predicate (trace : Engine.trace) : Witness.t =
  {
    initial = System.start r.context;
    steps = replayed r trace;
    last = state r trace.last;
    finish = finish r trace;
    facts = (match predicate with None -> [] | Some p -> facts r trace p);
  }

(** {2 Verdicts} *)

let reason r p : Engine.doubt -> Verdict.reason = function
  | Undefined text -> Undefined text
  | Zeno trace -> Zeno (witness r (Some p) trace)
  | Truncated reason -> (
      match cause r.options r.model r.horizon reason with
      | Bound t -> Truncated t
      | Fault text -> Fault text
      | Early -> Scc_base.Bug.fail __POS__ "an open question did not keep the exploration going")

let undecided r p doubts = Verdict.Undecided (List.map (reason r p) doubts)

let holds ?trace r p =
  Verdict.Holds { bounds = []; witness = Option.map (witness r (Some p)) trace }

let violated r p trace = Verdict.Violated { witness = Option.map (witness r (Some p)) trace }

(* Success up to a bound is one kind of verdict; what was not decided for another reason is not success. *)
let up_to_bound r p doubts =
  let bound = function
    | Verdict.Truncated { limit = Instant _; _ } -> None
    | Truncated t -> Some t
    | Undefined _ | Fault _ | Zeno _ -> None
  in
  let reasons = List.map (reason r p) doubts in
  let bounds = List.filter_map bound reasons in
  if List.length bounds = List.length reasons then Verdict.Holds { bounds; witness = None }
  else Undecided reasons

let now r p =
  match Trajectory.holds r.model (System.start r.context) p with
  | True -> holds r p
  | False -> violated r p (Some { steps = []; last = 0; finish = At_state })
  | Undecided text -> Undecided [ Undefined text ]

(* A plan whose leaves are answered in the order of {!questions}. *)
let rec verdict r (plan : Plan.t) (answers : Engine.answer list) =
  match (plan, answers) with
  | Now p, _ -> (now r p, answers)
  | Possibly (_, p), a :: rest ->
    ((match a with
        | Yes trace -> holds ?trace r p
        | No trace -> violated r p trace
        | Unknown doubts -> undecided r p doubts), rest)
  | Always (_, p), a :: rest ->
    ((match a with
        | Yes trace -> violated r p trace
        | No _ -> holds r p
        | Unknown doubts -> up_to_bound r p doubts), rest)
  | Eventually (_, p), a :: rest ->
    ((match a with
        | Yes _ -> holds r p
        | No trace -> violated r p trace
        | Unknown doubts -> undecided r p doubts), rest)
  | Not_eventually (_, p), a :: rest ->
    ((match a with
        | Yes _ -> violated r p None
        | No trace -> holds ?trace r p
        | Unknown doubts -> undecided r p doubts), rest)
  | All plans, _ -> verdicts r Verdict.conjunction plans answers
  | Any plans, _ -> verdicts r Verdict.disjunction plans answers
  | (Possibly _ | Always _ | Eventually _ | Not_eventually _), [] ->
    Scc_base.Bug.fail __POS__ "a question without an answer"

and verdicts r combine plans answers =
  let step (found, answers) plan =
    let v, answers = verdict r plan answers in
    (v :: found, answers)
  in
  let found, answers = List.fold_left step ([], answers) plans in
  (combine (List.rev found), answers)

(** {2 Questions} *)

let question context operator within p : Engine.question =
  { operator; within; goal = Predicate.make context p }

let rec questions context (plan : Plan.t) =
  match plan with
  | Now _ -> []
  | Possibly (within, p) -> [ question context Reach within p ]
  | Always (within, p) -> [ question context Reach within (Formula.negate p) ]
  | Eventually (within, p) | Not_eventually (within, p) -> [ question context Inevitable within p ]
  | All plans | Any plans -> List.concat_map (questions context) plans

(** {2 The report} *)

(* Most models have an event early on, and then the rest is not looked at. *)
let eventful r =
  let is_event (e : Graph.edge) =
    match label r e with
    | Time _ -> false
    | Bind _ | Bounce _ | Weak_split _ | Strong_split _ -> true
  in
  let rec from i =
    i < Graph.size r.graph && (Array.exists is_event (Graph.edges r.graph i) || from (i + 1))
  in
  from 0

let stats r : stats =
  let unexpanded = Graph.unexpanded r.graph in
  (* A state that was left may be one of millions. *)
  let causes =
    List.rev_map (fun (_, reason) -> cause r.options r.model r.horizon reason) unexpanded |> List.rev
  in
  let bounds = List.filter_map (function Bound t -> Some t | Fault _ | Early -> None) causes in
  {
    states = Graph.size r.graph;
    transitions = Graph.transitions r.graph;
    depth = Graph.greatest_depth r.graph;
    model_time = Graph.greatest_arrival r.graph;
    complete = (match unexpanded with [] -> true | _ :: _ -> false);
    eventful = eventful r;
    decided_early = List.exists (function Early -> true | Bound _ | Fault _ -> false) causes;
    stopped_by = Verdict.distinct bounds;
    faults =
      List.sort_uniq String.compare
        (List.filter_map (function Fault text -> Some text | Bound _ | Early -> None) causes);
  }

(* A cycle without duration, or else a run that met the guard. *)
let zeno r (result : Engine.result) =
  match result.zeno with
  | Some trace -> Some (witness r None trace)
  | None ->
    List.find_map
      (fun (i, (reason : _ Explore.reason)) ->
         match reason with
         | Instant ->
           Some (witness r None { steps = Graph.shortest_path r.graph i; last = i; finish = At_state })
         | Depth | Time | States | Seconds | Memory | Interrupted | Stopped | Fault _ -> None)
      (Graph.unexpanded r.graph)

(* Without edges a state takes a quarter of the memory; they are needed to look back from states to those before, and
   to pass on earlier times. *)
let needs_edges (q : Engine.question) =
  match q.operator with Engine.Reach -> Option.is_some q.within | Inevitable -> true

let rests context tuple =
  Network.quiescent (System.model context) (Catalogue.decode (System.catalogue context) tuple)

let run options model ~initial (checks : Property.check list) =
  let plans = List.map (fun (c : Property.check) -> (c, Plan.of_formula c.formula)) checks in
  let events = List.concat_map (fun (c : Property.check) -> Formula.events c.formula) checks in
  let context = System.make ~events model initial in
  let asked =
    List.concat_map (function _, Ok plan -> questions context plan | _, Error _ -> []) plans
  in
  let observe =
    Option.map (fun f _ _ tuple -> f (Catalogue.decode (System.catalogue context) tuple)) options.observe
  in
  let limits = limits options in
  let keep_edges = List.exists needs_edges asked || Option.is_some limits.time in
  let result =
    Engine.run ?observe ~keep_edges ~rests:(rests context) limits options.surroundings context asked
  in
  let horizon = Engine.horizon limits asked in
  let r = { options; model; context; graph = result.graph; horizon } in
  let step (outcomes, answers) (check, plan) =
    match plan with
    | Error what -> ((check, Not_yet what) :: outcomes, answers)
    | Ok plan ->
      let v, answers = verdict r plan answers in
      ((check, Verdict v) :: outcomes, answers)
  in
  let outcomes, _ = List.fold_left step ([], result.answers) plans in
  { outcomes = List.rev outcomes; stats = stats r; zeno = zeno r result }

let explore options model ~initial =
  let context = System.make model initial in
  let graph = Graph.run (limits options) options.surroundings context in
  let r = { options; model; context; graph; horizon = None } in
  (context, graph, stats r)
