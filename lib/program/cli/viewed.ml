open Scc_base
open Scc_semantics
open Scc_property
open Scc_verify
open Scc_loading
open Scc_verdicts
open Scc_runs
open Scc_reports
open Scc_view

type checks = All | Only of string | Unchecked

type options = {
  path : string;
  source : Source.t option;
  read_file : Loaded.reader option;
  given : Options.definitions;
  budget : Budget.t;
  checks : checks;
  schedule : string option;
  graph : int;
  plots : string list;
}

(* {1 What is shown} *)

let find_check name (checks : Property.check list) =
  match List.filter (fun (c : Property.check) -> String.equal c.name name) checks with
  | _ :: _ as found -> Ok found
  | [] -> Error [ Input.no_check Code.unknown_name Span.command_line name checks ]

let chosen_checks o checks =
  match o.checks with
  | All -> Ok checks
  | Only name -> find_check name checks
  | Unchecked -> Ok []

let about (outcome : Verdict.outcome) : Runs.about =
  {
    formula = outcome.check.text;
    verdict = Check_json.kind outcome.verdict;
    text = Verdict.outcome_to_string outcome;
  }

(* {1 The document} *)

type making = {
  loaded : Loaded.t;
  tables : Tables.t;
  states : States.t;
  plots : Property.num list;
  most : int;
  bits : int option;
  simulated : Shown_run.simulated option;
}

let until making = Option.map (fun s -> s.Shown_run.until) making.simulated

let world_of making semantics =
  States.world ?bits:making.bits making.states making.tables
    ~words:(fun m l -> Run_text.label m l)
    ~plots:making.plots semantics

let with_leaves making = Runs.with_leaves making.tables ~of_document:making.loaded.model

(* Follows the run again up to a step: that costs less than to keep all states. *)
let state_after (l : Loaded.t) policy (limits : Replay.limits) n =
  let found = ref None in
  let note : Replay.event -> unit = function
    | Step { number; state; _ } when number = n -> found := Some (state ())
    | Start _ | Step _ | Instant _ | End _ -> ()
  in
  let limits : Replay.limits = { limits with steps = Some n } in
  match (Replay.run l.semantics l.declared policy limits ~interrupted:(fun () -> false) note, !found) with
  | Ok _, Some state -> state
  | (Ok _ | Error _), _ -> Bug.fail __POS__ "a run that is not the same again"

let large_run making world ~name policy limits ~interrupted =
  let l = making.loaded in
  let run = ref None in
  let note (event : Replay.event) =
    match (event, !run) with
    | Start s, _ -> run := Some (Large_run.start world ~state_after:(state_after l policy limits) s)
    | _, Some r -> Large_run.step r event
    | _, None -> Bug.fail __POS__ "a run without a start"
  in
  let* how = Shown_run.replay l making.simulated policy limits ~interrupted note in
  let ending = Shown_run.ending l how in
  let told r = Large_run.run ?until:(until making) r ~name ~finish:(Trace.ending how) ~ending in
  match !run with Some r -> Ok (told r) | None -> Bug.fail __POS__ "a run without a start"

let small_run making world ~name policy limits ~interrupted =
  let l = making.loaded in
  let too_long state =
    match (policy : Replay.policy) with
    | First -> States.too_long world state
    | Random _ | Scheduled _ -> false
  in
  let* r = Shown_run.follow l making.simulated policy limits ~too_long ~interrupted in
  Ok
    (Runs.of_steps ?until:(until making) making.states world ~most:making.most ~name ~initial:r.initial r.steps
       ~offset:r.offset ~finish:(Trace.ending r.ending) ~ending:r.words)

let run_by_choices making = if Large_run.is_for making.loaded.model then large_run making else small_run making

let sample_steps = 60

(* A run from one start of a model with ranges. *)
let from_start making (l : Loaded.t) values ~name ~interrupted =
  let* point = Loaded.at l values in
  let at_point = { making with loaded = point } in
  let limits = { Replay.steps = Some sample_steps; time = None; instant = Replay.default_instant } in
  let world = world_of at_point point.semantics in
  let* run = run_by_choices at_point world ~name First limits ~interrupted in
  Ok { (with_leaves making point.model run) with values }

(* A run that no verdict rests on leads to what was not explored. *)
let unexplored (outcome : Verdict.outcome) (run : Runs.t) =
  match outcome.verdict with
  | Undecided _ ->
    let ending = [ "in the nearest unexplored state that matters" ] in
    { run with course = Option.map (fun c -> { c with Runs.ending }) run.course }
  | Holds _ | Violated _ | Measured _ | Depends _ -> run

let of_check making world (l : Loaded.t) ~interrupted (outcome : Verdict.outcome) =
  let name = outcome.check.name and about = about outcome in
  match (Verdict.shown outcome.verdict, outcome.scale.over) with
  | None, Some { example = _ :: _ as values; _ } ->
    let* run = from_start making l values ~name ~interrupted in
    Ok [ Runs.about run about ~ending:[ Check_text.no_run outcome.check.formula ] ]
  | None, _ -> Ok [ Runs.none ~name about ]
  | Some w, _ -> (
      let told world ~name about w = Runs.of_witness making.states world ~most:making.most ~name about w in
      let shown world = unexplored outcome (told world ~name (Some about) w) in
      let other world (o : Scc_explain.Witness.otherwise) =
        { (told world ~name:(name ^ ", otherwise") None o.run) with contrast = Some o.shared }
      in
      match w.fixed with
      | None -> Ok (shown world :: Option.to_list (Option.map (other world) w.otherwise))
      | Some f ->
        let world = world_of making f.semantics in
        Ok [ with_leaves making (Semantics.model f.semantics) (shown world) ])

(* What was found, and what of it is drawn over the starts. *)
let report console o (l : Loaded.t) checks watch =
  let exactly = Array.length l.model.ranges > 0 in
  match checks with
  | [] -> Ok ([], ([], []))
  | _ ->
    let* initial = Loaded.initial l in
    let options = { (Check_options.starting console watch o.budget) with contrast = true } in
    let run () = Verdicts.report options l ~initial ~exactly ~premises:[] checks in
    let* report =
      match (Watch.attempt watch).run Reporting run with
      | Ok report -> report
      | Error stop -> Ok (Check.unexplored options checks stop)
    in
    Console.progress_done console;
    List.iter (Console.fault console) (Check.faults report);
    Ok (report.outcomes, Drawn_checks.split report.outcomes (Drawn_checks.named report.outcomes report))

(* The model at one start, for what is about one. *)
let at_point (l : Loaded.t) =
  match Sample.values Simple l.model.ranges with [] -> Ok l | values -> Loaded.at l values

let first_steps = 200

(* Runs from here and there in the drawing of where checks hold. *)
let samples making (l : Loaded.t) view drawn ~interrupted =
  let run values =
    let* run = from_start making l values ~name:(Sample.to_string values) ~interrupted in
    Ok { run with sample = true }
  in
  let add all values =
    let* all = all in
    if interrupted () then Ok all else Result.map (fun r -> (values, r) :: all) (run values)
  in
  Result.map List.rev (List.fold_left add (Ok []) (Regions.starts l.model.ranges view drawn))

(* The drawing, and its runs. *)
let regions making (l : Loaded.t) drawn ~before ~interrupted =
  match drawn with
  | [], [] -> Ok (None, [])
  | checks, numbers -> (
      match Scc_regions.Plane.view l.model.ranges ~axes:[] ~fixed:[] with
      | Error _ -> Ok (None, [])
      | Ok view ->
        let drawn = Regions.drawn l.model.ranges view ~checks ~numbers in
        let* sampled = samples making l view drawn ~interrupted in
        let numbered = List.mapi (fun i (values, _) -> (values, before + i)) sampled in
        let where = { Regions.ranges = l.model.ranges; view; checks; numbers; drawn; samples = numbered } in
        Ok (Some where, List.map snd sampled))

let read_schedule console o =
  match o.schedule with
  | None -> Ok None
  | Some path -> Result.map Option.some (Scheduled.read console path)

let model console o schedule =
  let* l =
    match schedule with
    | None ->
      Input.model ?source:o.source ?read_file:o.read_file console ~overrides:o.given.values
        ~narrowed:o.given.narrowed o.path
    | Some s -> Scheduled.model console s ~given:o.given o.path
  in
  Console.report console l.warnings;
  Ok l

(* The runs of the checks and one more, and where checks hold. *)
let checked console o making world (l : Loaded.t) watch ~interrupted =
  let* checks = chosen_checks o l.checks in
  let* outcomes, starts = report console o l checks watch in
  let* runs = Result.all (of_check making world l ~interrupted) outcomes in
  let limits = { Replay.steps = Some first_steps; time = None; instant = Replay.default_instant } in
  let* first = run_by_choices making world ~name:"first choices" First limits ~interrupted in
  let runs = List.concat runs @ [ first ] in
  let* drawn, more = regions making l starts ~before:(List.length runs) ~interrupted in
  Ok (runs @ more, drawn)

let scheduled making world (s : Schedule.t) ~interrupted =
  let name = Option.value s.check ~default:"run" in
  let limits = { Replay.steps = None; time = None; instant = Replay.default_instant } in
  let* run = run_by_choices making world ~name (Scheduled s) limits ~interrupted in
  Ok ([ run ], None)

(* The numbers that are asked for, and the model in which they have their meaning. *)
let asked console (l : Loaded.t) texts =
  let* model, numbers =
    Observed.questions console l texts ~name:(fun _ text -> "--plot " ^ text)
      (fun _ _ question ~refuse ->
         match question with
         | Number n -> Ok n
         | State _ | Temporal _ -> refuse Code.bad_value "this is no number: a plot shows a number over time")
  in
  Ok ({ model with checks = l.checks }, numbers)

let document console o watch =
  let* schedule = read_schedule console o in
  let* l = model console o schedule in
  let* point = at_point l in
  let* point, numbers = asked console point o.plots in
  (* States of the runs that are found have to keep what the numbers speak of, too. *)
  let* l, _ = asked console l o.plots in
  let named = Curves.of_checks point.checks in
  let interrupted = Watch.interrupted watch in
  let making =
    {
      loaded = point;
      tables = Tables.create ();
      states = States.create ();
      plots = numbers @ List.filter (fun n -> not (List.exists (Formula.equal_num n) numbers)) named;
      most = Graph.bound point.model o.graph;
      bits = (match o.budget.bits with Some n -> Some n | None -> Bounds.value Bounds.default.bits);
      simulated = None;
    }
  in
  let world = world_of making point.semantics in
  let* initial = Loaded.initial point in
  let graph =
    if Large_run.is_for point.model then None
    else
      let stop = Watch.half watch () in
      let stopped () = Option.is_some (stop ()) in
      Some (Graph.explore making.states world ~most:making.most ~interrupted:stopped initial)
  in
  let* runs, where =
    match schedule with
    | Some s -> scheduled making world s ~interrupted
    | None -> checked console o making world l watch ~interrupted
  in
  Ok
    {
      Document.loaded = point;
      name = Filename.basename o.path;
      tables = making.tables;
      states = making.states;
      plots = making.plots;
      graph;
      runs;
      where;
      spread = None;
    }

(* {1 Runs of a simulation} *)

type simulation = {
  spread : Spread.t;
  limits : Replay.limits;
  numbers : Property.num list;
}

let most_runs = 20
let most_steps = 20_000
let most_bytes = 16_000_000

(* The bytes of the rows of states and processes from these numbers on, and the next numbers. *)
let bytes_since making (first_state, first_process) =
  let of_texts = List.fold_left (fun n text -> n + String.length text) 0 in
  let states = States.count making.states in
  let row i = Scc_json.Json.line (States.json making.states (first_state + i)) in
  let processes = Rows.since making.tables.processes first_process in
  ( of_texts (List.init (states - first_state) row) + of_texts processes,
    (states, first_process + List.length processes) )

(* A run of the table, as far as it is shown; one that an interruption has ended, to where it was last observed. *)
let simulated_run making world s (run : Spread.shown) ~cut ~interrupted =
  let seed = Scc_simulate.Simulation.seed_of s.spread.seed run.number in
  let time = match cut with Some time -> Some time | None -> s.limits.time in
  Option.iter (fun (m : Shown_run.simulated) -> m.steps <- 0) making.simulated;
  let name = Printf.sprintf "run %d" run.number in
  let* made = run_by_choices making world ~name (Random seed) { s.limits with time } ~interrupted in
  let shortened =
    match making.simulated with
    | Some { steps; most_steps; _ } when steps >= most_steps ->
      [ Printf.sprintf "the page shows its first %d transitions" steps ]
    | Some _ | None -> []
  in
  let how = match run.ended with Some text -> text | None -> "it comes to the last time of the table" in
  let again = Printf.sprintf "`scc trace --choose random:%Ld` makes it, too" seed in
  let ending = (how :: shortened) @ [ again ] in
  Ok { made with course = Option.map (fun c -> { c with Runs.ending }) made.course }

let simulated (l : Loaded.t) ~name s ~cut ~interrupted =
  let making =
    {
      loaded = l;
      tables = Tables.create ();
      states = States.create ();
      plots = s.numbers;
      most = 0;
      bits = None;
      simulated = Some { until = s.spread.times.(Array.length s.spread.times - 1); most_steps; steps = 0 };
    }
  in
  let world = world_of making l.semantics in
  let* initial = Loaded.initial l in
  ignore (States.start world initial);
  let rec go made bytes rows = function
    | (run : Spread.shown) :: rest when bytes < most_bytes ->
      if made <> [] && interrupted () then Ok (List.rev made, true)
      else begin
        match simulated_run making world s run ~cut:(cut run) ~interrupted with
        | Error _ as refused -> refused
        | Ok shown ->
          let more, rows = bytes_since making rows in
          go ((run, shown) :: made) (bytes + more) rows rest
      end
    | _ -> Ok (List.rev made, false)
  in
  let* made, hurried = go [] 0 (0, 0) s.spread.shown in
  let states = States.count making.states in
  let graph = { Graph.states; expanded = states; complete = false; bound = states } in
  Ok
    {
      Document.loaded = l;
      name;
      tables = making.tables;
      states = making.states;
      plots = making.plots;
      graph = (if Large_run.is_for l.model then None else Some graph);
      runs = List.map snd made;
      where = None;
      spread = Some { s.spread with shown = List.map fst made; hurried };
    }
