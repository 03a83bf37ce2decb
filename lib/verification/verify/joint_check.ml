open Scc_calculus
open Scc_semantics
open Scc_property
open Scc_graph_search
open Scc_evaluate
open Scc_state_space
open Scc_explain
module Graph = State_graph

type result = {
  outcomes : (Property.check * Verdict.t * Lost.taken) list;
  stats : Stats.t;
  zeno : Witness.t option;
  lost : Lost.taken;
  stores : (string * int) list;
  numbers : unit -> (string * int) list;
}

(** {2 Verdicts} *)

let trace (r : Unsettled.t) p trace =
  Unsettled.run r (fun () -> Some (Make_witness.of_trace r.context r.graph (Some p) trace))

let holds = Verdict.Holds { bounds = []; witness = None }

(* Success up to a bound is one kind of verdict; what was not decided for another reason is not success. *)
let up_to_bound r (doubts : Search.doubts) =
  let bound = function
    | Verdict.Truncated { limit = Instant _; _ } | Unevaluated _ | Undefined _ | Fault _ | Unexplored _ -> Error ()
    | Truncated t -> Ok t
  in
  let add acc reason =
    match (acc, bound reason) with
    | Ok bounds, Ok b -> Ok (b :: bounds)
    | Error (), _ | _, Error () -> Error ()
  in
  match List.fold_left add (Ok []) (Unsettled.undefined doubts @ Unsettled.causes r doubts.unexplored) with
  | Ok bounds -> Verdict.Holds { bounds = List.rev bounds; witness = None }
  | Error () -> Undecided (Unsettled.search_doubts r doubts)

let now (r : Unsettled.t) p =
  match Trajectory.holds (Network_lts.semantics r.context) (Network_lts.start r.context) p with
  | True -> Verdict.Holds { bounds = []; witness = trace r p { steps = []; last = 0; finish = At_state } }
  | False -> Violated { witness = trace r p { steps = []; last = 0; finish = At_state } }
  | Undecided text -> Undecided [ Undefined text ]

(* An evaluation that takes longer than there is time for leaves one formula open, and nothing else; what is known
   by then stays known. *)
let evaluated (r : Unsettled.t) temporal i : Verdict.t =
  match Unsettled.evaluated r (fun () -> Formulas.truth (Temporal.formulas temporal) i) with
  | Error why -> Undecided why
  | Ok None -> Undecided (Measuring.formula_doubts r temporal i)
  | Ok (Some truth) -> (
      match (truth, Unsettled.explained r temporal i) with
      | true, witness -> Holds { bounds = []; witness }
      | false, witness -> Violated { witness })

let formula r temporal i =
  let v = evaluated r temporal i in
  Formulas.done_with (Temporal.formulas temporal) i;
  v

(* Answers and formulas are taken up in the order of [questions] and [formulas]. *)
type answers = { searches : Search.answer list; next_formula : int; temporal : Temporal.t option }

let rec verdict r (plan : Plan.t) answers =
  match (plan, answers.searches) with
  | Now p, _ -> (now r p, answers)
  | Possibly (_, p), a :: searches ->
    ((match a with
        | Met t -> Verdict.Holds { bounds = []; witness = trace r p t }
        | Never -> Violated { witness = None }
        | Open doubts -> Undecided (Unsettled.search_doubts r doubts)), { answers with searches })
  | Always (_, p), a :: searches ->
    ((match a with
        | Met t -> Verdict.Violated { witness = trace r p t }
        | Never -> holds
        | Open doubts -> up_to_bound r doubts), { answers with searches })
  | Formula _, _ -> (
      match answers.temporal with
      | None -> Scc_base.Bug.fail __POS__ "a formula that was not asked"
      | Some t ->
        (formula r t answers.next_formula, { answers with next_formula = answers.next_formula + 1 }))
  | All plans, _ -> verdicts r Verdict.conjunction plans answers
  | Any plans, _ -> verdicts r Verdict.disjunction plans answers
  | (Possibly _ | Always _), [] -> Scc_base.Bug.fail __POS__ "a question without an answer"

and verdicts r combine plans answers =
  let step (found, answers) plan =
    let v, answers = verdict r plan answers in
    (v :: found, answers)
  in
  let found, answers = List.fold_left step ([], answers) plans in
  (combine (List.rev found), answers)

(* A number that is asked for. *)
let measured answers find =
  let i = answers.next_formula in
  let temporal =
    match answers.temporal with Some t -> t | None -> Scc_base.Bug.fail __POS__ "a question that was not asked"
  in
  let v = find temporal i in
  Formulas.done_with (Temporal.formulas temporal) i;
  (v, { answers with next_formula = i + 1 })

(* Runs have the chances of one value of the parameter, and are not shown. *)
let without_run : Verdict.t -> Verdict.t = function
  | Holds { bounds; witness = _ } -> Holds { bounds; witness = None }
  | Violated { witness = _ } -> Violated { witness = None }
  | (Measured _ | Depends _ | Undecided _) as v -> v

let functional (r : Unsettled.t) (range : Ranges.range) sensitivity ((check : Property.check), plan) answers =
  let s () = Lazy.force (Option.get sensitivity) in
  match check.asked with
  | Whether when Formula.asks_probability check.formula ->
    measured answers (fun t i -> Measuring.claim_function r t (s ()) i check.formula range)
  | Whether ->
    let v, answers = verdict r plan answers in
    (without_run v, answers)
  | How_likely sides -> measured answers (fun t i -> Measuring.probability_function r t (s ()) i sides range)
  | Expected (sides, mean, test) ->
    measured answers (fun t i -> Measuring.mean_function r t (s ()) i sides mean test range)

let outcome (options : Setup.t) r ((check : Property.check), plan) answers =
  match check.asked with
  | Whether -> verdict r plan answers
  | How_likely sides ->
    let curve = Option.equal String.equal options.curve (Some check.name) in
    measured answers (fun t i -> Measuring.probability r t i sides ~curve)
  | Expected (sides, mean, test) -> measured answers (fun t i -> Measuring.mean r t i sides mean test)

(** {2 Questions} *)

let question context bound goal : Search.question =
  let initial = Network_lts.start context in
  let within = Known_early.within (Network_lts.model context) ~initial bound goal in
  { within; goal = Predicate.make context goal }

let rec questions context (plan : Plan.t) : Search.question list =
  match plan with
  | Now _ | Formula _ -> []
  | Possibly (bound, p) -> [ question context bound p ]
  | Always (bound, p) -> [ question context bound (Formula.negate p) ]
  | All plans | Any plans -> List.concat_map (questions context) plans

let rec formulas (plan : Plan.t) =
  match plan with
  | Now _ | Possibly _ | Always _ -> []
  | Formula f -> [ f ]
  | All plans | Any plans -> List.concat_map formulas plans

(* What is asked of the formulas, in their order. *)
let on_graph checks plans : Known_early.question list =
  let of_check (c : Property.check) plan = List.map (fun _ -> c.asked) (formulas plan) in
  List.mapi
    (fun formula asked -> { Known_early.asked; formula })
    (List.concat (List.map2 of_check checks plans))

(* Time beyond which nothing is asked. *)
let horizon (checks : Property.check list) =
  match checks with
  | [] -> None
  | _ :: _ -> Plan.latest_horizon (List.map (fun (c : Property.check) -> c.formula) checks)

(** {2 The report} *)

let is_event context (e : Graph.edge) =
  match Catalogue.single (Network_lts.catalogue context) e.label with
  | Some label -> not (Transition.is_time label)
  | None -> true

let stats (r : Unsettled.t) causes { Besides.slow; likely; long; ended } : Stats.t =
  {
    states = Graph.size r.graph;
    transitions = Graph.transitions r.graph;
    depth = Graph.greatest_depth r.graph;
    model_time = Some (Graph.greatest_arrival r.graph);
    complete = Graph.left r.graph = 0;
    eventful = Catalogue.has_events (Network_lts.catalogue r.context);
    split_step = Network_lts.split_step r.context;
    decided_early = List.exists (function Bounds.Early -> true | Bound _ | Fault _ -> false) causes;
    stopped_by = Unsettled.stopped_by causes;
    dead_ends = Bounds.dead_ends r.context;
    growth = long;
    shared = Shared_edge.warning r.context;
    causes = likely;
    converges = slow;
    left_out = ended;
    faults =
      List.sort_uniq Scc_base.Diag.compare
        (List.filter_map (function Bounds.Fault f -> Some f | Bound _ | Early -> None) causes);
  }

(* A cycle without duration, or else a run that met the guard. *)
let zeno (r : Unsettled.t) (result : Search.result) =
  match result.zeno with
  | Some t -> Unsettled.run r (fun () -> Some (Make_witness.of_trace r.context r.graph None t))
  | None ->
    let path i = Unsettled.run r (fun () -> Some (Make_witness.of_path r.context r.graph i)) in
    Option.bind (Unsettled.first r Instant) path

(* Without edges a state takes a quarter of the memory. They are needed to look back from states to those before,
   and worth keeping where earlier times may have to be passed on. *)
let needs_edges plans limits =
  List.exists (fun p -> List.length (formulas p) > 0) plans || Option.is_some limits.Limits.time

let rests context tuple =
  Network.quiescent (Network_lts.semantics context) (Catalogue.decode (Network_lts.catalogue context) tuple)

let stores (r : Unsettled.t) =
  let m = Graph.memory r.graph in
  [ ("states", m.states); ("labels", m.labels); ("edges", m.edges) ]

(* Those that are searched for, and those that are evaluated on the graph. *)
let kinds_of (checks : Property.check list) plans =
  let all = List.combine checks plans in
  let formulas_of test =
    List.filter_map (fun ((c : Property.check), plan) -> if test plan then Some c.formula else None) all
  in
  (formulas_of Plan.is_search, formulas_of (fun plan -> not (Plan.is_search plan)))

let time_seen (options : Setup.t) model checks = Reduction.time_seen options.reductions model checks

let system (options : Setup.t) semantics ~initial checks plans =
  let model = Semantics.model semantics in
  let searched, evaluated = kinds_of checks plans in
  let events = List.concat_map (fun (c : Property.check) -> Formula.events c.formula) checks in
  let deep = match options.bounds.depth with Unbounded -> false | Default _ | Given _ -> true in
  Network_lts.make ~events
    ~time_seen:(time_seen options model checks)
    ~quotient:(Reduction.quotient options.reductions model initial ~checks ~searched ~evaluated)
    ?visible:(Reduction.visible options.reductions ~deep ~searched ~evaluated)
    ~joined:(Reduction.joins options.reductions model checks)
    ?units:(Reduction.seen_on_courses options.reductions model checks)
    semantics initial

(* A question for a number is one about the graph, whatever the formula is. *)
let plan (c : Property.check) : Plan.t =
  match c.asked with Whether -> Plan.of_formula c.formula | How_likely _ | Expected _ -> Formula c.formula

(* With a parameter, tests of probabilities are functions of the whole graph. *)
let plan_of (options : Setup.t) (c : Property.check) : Plan.t =
  if Option.is_some options.parameter && Formula.asks_probability c.formula then Formula c.formula else plan c

(* What holds for one value of the parameter may not hold for others: then all has to be known. *)
let early (options : Setup.t) checks =
  let is_test (c : Property.check) = c.asked = Whether && Formula.asks_probability c.formula in
  Option.is_none options.parameter || not (List.exists is_test checks)

let unsettled (options : Setup.t) context graph ~horizon : Unsettled.t =
  {
    bounds = options.bounds;
    surroundings = options.surroundings;
    model = Network_lts.model context;
    context;
    graph;
    horizon;
    lost = Lost.make options.bounds options.surroundings.attempt;
    contrast = options.contrast;
  }

(* The name alone would not do: it is also that of what has to come true for the check to say anything. *)
let about = function
  | [] -> "no property"
  | checks -> String.concat "; " (List.map (fun (c : Property.check) -> c.name ^ ": " ^ c.text) checks)

(* Concludes about the checks in their order, each in its share of the time; [around] holds the surroundings of the
   check whose turn it is. *)
let conclude (options : Setup.t) (r : Unsettled.t) around sensitivity checks answers =
  let step (outcomes, answers) ((check, plan), share) =
    let { Setup.surroundings; bounds; _ } = Setup.share options share in
    around := surroundings;
    let r = { r with surroundings; lost = Lost.make bounds surroundings.attempt } in
    let v, answers =
      match options.parameter with
      | None -> outcome options r (check, plan) answers
      | Some { parameter; _ } -> functional r parameter sensitivity (check, plan) answers
    in
    ((check, v, Lost.taken r.lost) :: outcomes, answers)
  in
  let outcomes, _ = List.fold_left step ([], answers) (Setup.shares ~size:(fun _ -> 1) ~after:0 checks) in
  List.rev outcomes

(* An exploration for some checks, and what it was for. *)
type explored = {
  context : Network_lts.context;
  horizon : Scc_exact.Rat.t option;
  asked : Temporal.asked;
  asks : bool;  (** something is evaluated on the graph *)
  found : Search.result;
  drawing : int option;
}

let rec explored ~looks_ahead (options : Setup.t) semantics ~initial (checks : Property.check list) plans =
  let context = system options semantics ~initial checks plans in
  let questions = List.concat_map (questions context) plans and temporals = List.concat_map formulas plans in
  let horizon = Known_early.horizon (Network_lts.model context) ~initial:(Network_lts.start context) checks in
  let limits = Bounds.limits options.bounds ~horizon in
  let rests = rests context in
  let observe =
    Option.map (fun f _ _ tuple -> f (Catalogue.decode (Network_lts.catalogue context) tuple)) options.observe
  in
  let asked = Temporal.ask context temporals in
  let settled =
    if early options checks then Known_early.settled options.surroundings asked ~rests (on_graph checks plans)
    else Some (fun _ -> false)
  in
  let drawing = if looks_ahead then Draws_ahead.find options context checks limits else None in
  let is_tried = Option.is_some drawing in
  let limits = if is_tried then Draws_ahead.few limits else limits in
  let expanding = if is_tried then Graph.here else options.expanding ~about:(about checks) in
  let found =
    Search.run ?observe ?settled ~order:options.order ~keep_edges:(needs_edges plans limits) ~expanding ~rests
      limits options.surroundings context questions
  in
  if is_tried && not (Draws_ahead.confirmed found.graph) then
    explored ~looks_ahead:false options semantics ~initial checks plans
  else { context; horizon; asked; asks = temporals <> []; found; drawing }

(* One exploration for some checks. *)
let check (options : Setup.t) semantics ~initial (checks : Property.check list) =
  let plans = List.map (plan_of options) checks in
  let e = explored ~looks_ahead:true options semantics ~initial checks plans in
  let options = { options with bounds = { options.bounds with drawing = e.drawing } } in
  let graph = e.found.graph in
  let r = unsettled options e.context graph ~horizon:e.horizon in
  (* Of the check whose turn it is. *)
  let around = ref options.surroundings in
  let surroundings = { !around with stop = (fun () -> !around.stop ()); half = (fun () -> !around.half ()) } in
  let seconds = Bounds.value options.bounds.seconds in
  let on_graph () = Temporal.on ~surroundings ?seconds e.asked ~rests:(rests e.context) graph in
  let temporal = if e.asks then Some (on_graph ()) else None in
  let sensitivity =
    Option.map (fun t -> lazy (Temporal.sensitivity t (Option.get options.parameter).parameter)) temporal
  in
  let met = Unsettled.met r in
  let besides = Besides.find r met in
  let answers = { searches = e.found.answers; next_formula = 0; temporal } in
  let outcomes = conclude options r around sensitivity (List.combine checks plans) answers in
  (* Where all is decided, nobody needs to know why it did not close. *)
  let bounded (_, v, _) = match Verdict.truncated v with [] -> false | _ :: _ -> true in
  let besides = if checks = [] || List.exists bounded outcomes then besides else Besides.none in
  let zeno = zeno r e.found in
  {
    outcomes;
    stats = stats r met besides;
    zeno;
    lost = Lost.taken r.lost;
    stores = stores r;
    numbers = (fun () -> Catalogue.longest (Network_lts.catalogue e.context));
  }

let explore ?time_seen ?(visitor = fun _ -> Graph.blind) (options : Setup.t) semantics ~initial =
  let context = Network_lts.make ?time_seen semantics initial in
  let limits = Bounds.limits options.bounds ~horizon:None in
  let graph =
    Graph.run ~visitor:(visitor context) ~order:options.order
      ~expanding:(options.expanding ~about:"all states")
      limits options.surroundings context
  in
  let r = unsettled options context graph ~horizon:None in
  let met = Unsettled.met r in
  (context, graph, stats r met (Besides.find r met))

let may_have_events (options : Setup.t) semantics ~initial =
  let time_seen = time_seen options (Semantics.model semantics) [] in
  let context = Network_lts.make ~time_seen semantics initial in
  let few = { Limits.unlimited with states = Some 5_000 } in
  let found = ref false in
  let opened _ _ _ edges = if Array.exists (is_event context) edges then found := true in
  let visitor = { Graph.blind with opened = Some opened; enough = (fun () -> !found) } in
  let graph = Graph.run ~visitor few options.surroundings context in
  !found || not (Graph.complete graph)
