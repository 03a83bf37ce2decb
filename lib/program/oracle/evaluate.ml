open Scc_ctl
open Scc_base
open Scc_exact
open Scc_semantics
open Scc_evaluate
open Scc_verify
open Scc_loading
open Scc_verdicts
open Scc_json
open Scc_runs
open Scc_reports
open Json_format

type bounds = { seconds : float; memory : int; now : unit -> float }

(* {1 What kind of formula it is} *)

let read store ~handle ~formula =
  let load = Models.with_formula store ~handle ~formula in
  match Question.ask ~model:(fun (l : Models.loaded) -> l.model) load with
  | Ok found -> found
  | Error diagnostics ->
    let source = Models.sources store handle ~formula in
    Fault.refuse (Formula_refused (Fault.diagnostics ~source diagnostics))

(* {1 At a state} *)

let trajectory semantics (place : Network_at.place) extent =
  let arrived event =
    match place.last with
    | None -> false
    | Some (source, label) -> Event.matches ~source label event
  in
  Trajectory.make ~arrived semantics place.state extent

let at semantics place = trajectory semantics place Timeline.Instant

let valued kind format =
  fields
    [
      fixed "kind" (`String kind);
      field "value" (nullable format) Result.to_option;
      field "reason" (nullable text) (function Ok _ -> None | Error reason -> Some reason);
    ]

let state p (l : Models.loaded) prop =
  let place = Models.path p l.network in
  match (Trajectory.prop (at l.model.semantics place) prop).start with
  | True -> Ok true
  | False -> Ok false
  | Undecided reason -> Error reason

let number p (l : Models.loaded) num =
  let place = Models.path p l.network in
  match (Trajectory.num (at l.model.semantics place) num).start with
  | Undefined reason -> Error reason
  | Ratio (n, d) ->
    let at_start polynomial = Polynomial.eval polynomial Rat.zero in
    Ok (Rat.div (at_start n) (at_start d))

(* {1 Over runs} *)

(* Of the time and the memory there are, the rest is for reading, telling and stopping. *)
let share = 0.8

let stop bounds ~last =
  let words = int_of_float (share *. float_of_int bounds.memory) in
  let round = ref 0 in
  fun () : Scc_graph_search.Limits.stop option ->
    incr round;
    if bounds.now () > last then Some Seconds
    else if !round land 255 = 0 && Memory.heap_words () > words then Some Memory
    else None

let surroundings bounds : Scc_graph_search.Limits.surroundings =
  let rec until last : Scc_graph_search.Limits.surroundings =
    let after part =
      let now = bounds.now () in
      until (now +. (part *. (last -. now)))
    in
    let half () = after 0.5 and share ~mine ~all = after (float_of_int mine /. float_of_int all) in
    { Scc_graph_search.Limits.quiet with stop = stop bounds ~last; half; share }
  in
  until (bounds.now () +. (share *. bounds.seconds))

let options bounds p : Setup.t =
  let q = Read.quotas p in
  let given = Read.optional p Method.all_limits in
  let limit member = Option.bind given (fun g -> Read.optional g member) in
  let states = limit Method.states in
  (match states with
   | Some n when n > q.states -> Fault.refuse (Limit ("states", q.states))
   | Some _ | None -> ());
  let time = limit Method.time in
  let depth = limit Method.depth in
  let seconds = Some (share *. bounds.seconds) in
  let budget = { Budget.depth; time; states; seconds; memory = None; bits = None } in
  let memory = int_of_float (share *. float_of_int bounds.memory) in
  {
    Setup.default with
    bounds = Budget.bounds { states = Quotas.default_states; memory; room = None } budget;
    surroundings = surroundings bounds;
  }

let verdict =
  let outcome f (_, _, outcome, _) = f outcome in
  fields
    [
      fixed "kind" (`String "temporal");
      field "verdict" Check_json.kind_format (outcome (fun (o : Verdict.outcome) -> Check_json.kind o.verdict));
      field "report" Check_json.property_format (fun (_, semantics, outcome, _) ->
          Check_json.judged semantics outcome);
      field "explored" Explored_json.format (fun (model, _, _, stats) -> (model, stats));
    ]

let temporal bounds p (l : Models.loaded) check =
  let options = options bounds p in
  let place = Models.path p l.network in
  let semantics = l.model.semantics in
  let report = Check.run options semantics ~initial:place.state [ check ] in
  match report.outcomes with
  | [ outcome ] -> (l.model.model, semantics, outcome, report.stats)
  | _ -> Bug.fail __POS__ "one check has one verdict"

let formula =
  let bounded p _ text =
    let most = (Read.quotas p).formula_bytes in
    if String.length text > most then Fault.refuse (Limit ("formula_bytes", most)) else text
  in
  Read.member "formula" (Read.map bounded Read.text)

let params = Read.[ needs Models.handle; may Models.along; needs formula ]

let asked store p =
  let handle = Read.required p Models.handle in
  let base = Models.model store p in
  let formula = Read.required p formula in
  (* A path that is not possible is told before anything else. *)
  ignore (Models.path p base.network);
  read store ~handle ~formula

let evaluate =
  let params = params @ [ Read.may Method.all_limits ] in
  let result =
    union
      [
        case (valued "state" bool) (function `Truth x -> Some x | _ -> None) ignore;
        case (valued "number" Answers.quantity) (function `Quantity x -> Some x | _ -> None) ignore;
        case verdict (function `Verdict x -> Some x | _ -> None) ignore;
      ]
  in
  let work (bounds, store) p =
    match asked store p with
    | l, Question.State prop -> `Truth (state p l prop)
    | l, Number num -> `Quantity (number p l num)
    | l, Temporal check -> `Verdict (temporal bounds p l check)
  in
  Method.make "evaluate" params result work

(* {1 Along a path} *)

(* Where the transitions cannot be computed, nothing is known to come. *)
let extent (l : Models.loaded) (place : Network_at.place) (next : Transition.label option) : Timeline.extent =
  match next with
  | Some (Time d) when Rat.sign d > 0 -> Lasts d
  | Some _ -> Instant
  | None -> (
      match Network_at.next l.network place with
      | transitions -> Trajectory.extent l.model.semantics place.state transitions
      | exception Fault.Refused (No_transitions _) -> Instant)

let along_format =
  fields
    [
      field "kind" (word Fun.id [ "number"; "state" ]) fst;
      field "values" (list ~least:1 Curve_json.format) snd
        ~about:"Of each state of the path, the initial one first.";
    ]

let along p (l : Models.loaded) kind piece =
  let one place next = piece (trajectory l.model.semantics place (extent l place next)) in
  (kind, Network_at.along l.network (Models.choices p) one)

let values =
  let params = params @ [ Method.limits ] in
  let work store p =
    match asked store p with
    | l, Question.State prop ->
      let predicate = Trajectory.predicate l.model.semantics prop in
      along p l "state" (fun t -> Curve_json.truth (predicate t))
    | l, Number num -> along p l "number" (fun t -> Curve_json.number (Trajectory.num t num))
    | _, Temporal _ ->
      Fault.invalid (Member "formula")
        "a temporal formula is about whole runs: `evaluate` answers it. A number or a state predicate is expected"
  in
  Method.make "values" params along_format work
