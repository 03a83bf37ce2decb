open Scc_base
open Scc_calculus
open Scc_semantics
open Scc_property
open Scc_verify
open Scc_loading
open Scc_verdicts

type model = { loaded : Loaded.t; source : string -> Source.t option }

type problem = {
  code : string;
  is_error : bool;
  message : string;
  place : (string * int * int) option;
  hint : string option;
  text : string;
}

(* {1 Models} *)

let problem source (d : Diag.t) =
  let place =
    if Span.is_none d.span then None
    else
      let line, column =
        match source d.span.file with
        | Some text when not d.span.whole -> Source.position text d.span.start
        | Some _ | None -> (1, 1)
      in
      Some (d.span.file, line, column)
  in
  {
    code = d.code;
    is_error = Diag.is_error d;
    message = d.message;
    place;
    hint = d.hint;
    text = Diag.render ~source d;
  }

let problems source result = Result.map_error (List.map (problem source)) result

let refused fmt = Diag.error Code.bad_value Span.none fmt

(* Infinity and 0/0 are values of Zarith, and no numbers of models. A fraction that a program has put together by
   itself may not be in its lowest terms. *)
let finite set =
  let set = List.map (fun (name, (value : Q.t)) -> (name, Q.make value.num value.den)) set in
  match List.find_opt (fun (_, value) -> not (Q.is_real value)) set with
  | Some (name, value) -> Error [ refused "the value of `%s` is no number: %s" name (Q.to_string value) ]
  | None -> Ok set

let not_negative what n = if n < 0 then Error [ refused "%s is negative: %d" what n ] else Ok ()

let load ?(read = fun _ -> Error "no file can be read here") ?(set = []) ?(name = "<model>") text =
  let main = Source.make ~name text in
  let source file =
    if String.equal file name then Some main
    else Result.to_option (Result.map (Source.make ~name:file) (read file))
  in
  Result.bind (finite set) (fun overrides -> Loaded.load ~read_file:read ~overrides main)
  |> Result.map (fun loaded -> { loaded; source })
  |> problems source

let content path =
  let read channel = really_input_string channel (in_channel_length channel) in
  let text () =
    let channel = open_in_bin path in
    Fun.protect ~finally:(fun () -> close_in_noerr channel) (fun () -> read channel)
  in
  match if Sys.is_directory path then Error "it is a folder" else Ok (text ()) with
  | result -> result
  | exception Sys_error message -> Error message
  | exception End_of_file -> Error "it has become shorter while it was read"

let load_file ?set path =
  match content path with
  | Ok text ->
    let read name =
      content (if Filename.is_relative name then Filename.concat (Filename.dirname path) name else name)
    in
    load ~read ?set ~name:path text
  | Error message ->
    let d = Diag.error Code.cannot_read (Span.whole path) "cannot read: %s" message in
    Error [ problem (fun _ -> None) d ]

let warnings m = List.map (problem m.source) m.loaded.warnings

(* {1 Transitions} *)

type state = State.t
type body = { body : string; position : Q.t * Q.t * Q.t; behaviour : string }

type transition = {
  kind : string;
  label : string;
  duration : Q.t;
  chance : Q.t option;
  target : state;
}

let initial m =
  problems m.source
    (let* loaded = Ordinary.refuse m.loaded in
     Loaded.initial loaded)

let successors m state =
  let own = m.loaded.model in
  let transition (t : Transition.t) =
    {
      kind = Scc_runs.State_json.kind t.label;
      label = Transition.label_to_string own t.label;
      duration = (Transition.duration t : Scc_exact.Rat.t);
      chance = t.chance;
      target = t.target;
    }
  in
  match Network.successors m.loaded.semantics state with
  | Ok next -> Ok (List.map transition next)
  | Error fault -> Error [ problem m.source (Transition.diagnostic own fault) ]

let quiescent m state = Network.quiescent m.loaded.semantics state

let bodies m (state : state) =
  let own = m.loaded.model in
  let body (l : State.leaf) =
    let at = State.centroid own l in
    {
      body = own.leaves.(l.leaf).name;
      position = (at.x, at.y, at.z);
      behaviour = Scc_runs.State_json.behaviour own ~leaf:l.leaf l.behaviour;
    }
  in
  let of_process (p : State.process) = Array.to_list p.leaves in
  let leaves = List.concat_map of_process (Array.to_list state.processes) in
  List.map body (List.sort (fun (a : State.leaf) (b : State.leaf) -> Int.compare a.leaf b.leaf) leaves)

let equal = State.equal
let hash = State.hash

(* {1 Checks} *)

type verdict = { name : string; formula : string; kind : string; text : string }

type report = {
  verdicts : verdict list;
  states : int;
  transitions : int;
  complete : bool;
  json : (string -> unit) -> unit;
}

let most_states = 200_000

let setup ~states ~depth ~stop : Setup.t =
  let budget = { Budget.depth; time = None; states = Some states; seconds = None; memory = None; bits = None } in
  let stop () = if stop () then Some Scc_graph_search.Limits.Interrupted else None in
  {
    Setup.default with
    bounds = Budget.bounds { states; memory = max_int; room = None } budget;
    surroundings = Scc_graph_search.Limits.undivided ~stop ();
  }

let outcomes setup (l : Loaded.t) =
  let* initial = Loaded.initial l in
  let exactly = Array.length l.model.ranges > 0 in
  Verdicts.report setup l ~initial ~exactly ~premises:[] l.checks

let exit_code (report : Check.report) : Exit_code.t =
  match report.outcomes with
  | [] ->
    let s = report.stats in
    Exit_code.of_exploration ~complete:s.complete ~faults:s.faults ~stopped_by:s.stopped_by
  | all -> Exit_code.worst (List.map (fun (o : Verdict.outcome) -> Exit_code.of_verdict o.verdict) all)

let report_json m (report : Check.report) put =
  let diagnostics = m.loaded.warnings @ report.stats.faults @ report.stats.dead_ends in
  Scc_reports.Check_json.document ~source:m.source
    {
      loaded = m.loaded;
      verdicts = report.outcomes;
      where = [];
      report;
      diagnostics;
      exit = Exit_code.to_int (exit_code report);
      full = false;
      cure = (fun _ -> None);
      coverage = None;
      measured = None;
    }
  |> Scc_json.Json.pretty_pieces put

let verdict (o : Verdict.outcome) =
  let check : Property.check = o.check in
  {
    name = check.name;
    formula = check.text;
    kind = Scc_reports.Check_json.kind o.verdict;
    text = Verdict.outcome_to_string o;
  }

let check ?(states = most_states) ?depth ?(stop = fun () -> false) m =
  let answer (report : Check.report) =
    {
      verdicts = List.map verdict report.outcomes;
      states = report.stats.states;
      transitions = report.stats.transitions;
      complete = report.stats.complete;
      json = report_json m report;
    }
  in
  let made =
    let* () = not_negative "the bound on states" states in
    let* () = not_negative "the bound on depth" (Option.value depth ~default:0) in
    outcomes (setup ~states ~depth ~stop) m.loaded
  in
  Result.map answer (problems m.source made)

(* {1 Pictures} *)

let picture m state = Scc_picture.Picture.(svg m.loaded.model state default)

module View = Scc_view

type making = { point : Loaded.t; tables : View.Tables.t; all : View.States.t; most : int }

let world_of made ~plots semantics =
  View.States.world made.all made.tables ~words:Transition.label_to_string ~plots semantics

(* A run from one start of many has the model at this start. *)
let run_of made world ~plots (o : Verdict.outcome) =
  let { name; formula; kind; text } = verdict o in
  let about = { View.Runs.formula; verdict = kind; text } in
  let told world = View.Runs.of_witness made.all world ~most:made.most ~name (Some about) in
  match Verdict.shown o.verdict with
  | None -> View.Runs.none ~name about
  | Some ({ fixed = None; _ } as w : Scc_explain.Witness.t) -> told world w
  | Some ({ fixed = Some f; _ } as w) ->
    let own = Semantics.model f.semantics in
    View.Runs.with_leaves made.tables ~of_document:made.point.model own (told (world_of made ~plots f.semantics) w)

(* Where checks hold, for a model with ranges. *)
let where (l : Loaded.t) (report : Check.report) =
  match Drawn_checks.(split report.outcomes (named report.outcomes report)) with
  | [], [] -> None
  | checks, numbers -> (
      let ranges = l.model.ranges in
      match Scc_regions.Plane.view ranges ~axes:[] ~fixed:[] with
      | Error _ -> None
      | Ok view ->
        let drawn = View.Regions.drawn ranges view ~checks ~numbers in
        Some { View.Regions.ranges; view; checks; numbers; drawn; samples = [] })

(* Of a model with ranges, the page shows the states of one start. *)
let at_a_start (l : Loaded.t) =
  match Scc_runs.Sample.values Simple l.model.ranges with [] -> Ok l | values -> Loaded.at l values

let document ~states ~title (l : Loaded.t) =
  let* () = not_negative "the bound on states" states in
  let* point = at_a_start l in
  let* initial = Loaded.initial point in
  let* report = outcomes (setup ~states:most_states ~depth:None ~stop:(fun () -> false)) l in
  let tables = View.Tables.create () and all = View.States.create () in
  let plots = View.Curves.of_checks point.checks in
  let made = { point; tables; all; most = View.Graph.bound point.model states } in
  let world = world_of made ~plots point.semantics in
  let graph = View.Graph.explore all world ~most:made.most ~interrupted:(fun () -> false) initial in
  let runs = List.map (run_of made world ~plots) report.outcomes in
  let graph = Some graph and where = where l report in
  Ok { View.Document.loaded = point; name = title; tables; states = all; plots; graph; runs; where; spread = None }

let page ?(states = 1000) ~title m put =
  let write document = View.Page.write ~title (View.Document.write document) put in
  Result.map write (problems m.source (document ~states ~title m.loaded))
