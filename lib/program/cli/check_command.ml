open Scc_base
open Scc_state_space
open Scc_verify
open Scc_loading
open Scc_verdicts
open Scc_json
open Scc_reports
open Cmdliner

(* A model without properties is explored all the same. *)
let exit_code (report : Check.report) verdicts =
  let of_report =
    match verdicts with
    | [] ->
      let s = report.stats in
      Exit_code.of_exploration ~complete:s.complete ~faults:s.faults ~stopped_by:s.stopped_by
    | _ -> Exit_code.worst (List.map (fun (o : Verdict.outcome) -> Exit_code.of_verdict o.verdict) verdicts)
  in
  match Check.faults report with [] -> of_report | _ :: _ -> Exit_code.worst [ of_report; Bug ]

let make_folder path =
  let fail message =
    let at = Span.of_file path in
    Error (Diag.error Code.cannot_write at "cannot make the folder: %s" message)
  in
  match Sys.is_directory path with
  | true -> Ok ()
  | false -> fail "it is a file"
  | exception Sys_error _ -> (
      match Sys.mkdir path 0o777 with
      | () -> Ok ()
      | exception Sys_error message -> fail (Os_error.reason path message))

let write_file path text = Whole_file.with_file path (fun put -> put text)

let witness_file folder (check : Scc_property.Property.check) = Filename.concat folder (check.name ^ ".json")

(* As many of them as can be written; and what was wrong with the first that cannot. *)
let write_witnesses loaded path folder verdicts =
  let one ({ check; verdict; _ } : Verdict.outcome) =
    match Verdict.shown verdict with
    | None -> Ok ()
    | Some w ->
      let schedule = Scheduled.of_witness loaded path check w in
      write_file (witness_file folder check) (Scc_runs.Schedule.to_string schedule)
  in
  let* () = make_folder folder in
  let add before v =
    match (before, one v) with
    | Ok (), result -> result
    | (Error _ as first), _ -> first
  in
  List.fold_left add (Ok ()) verdicts

(* What was asked for besides the verdicts. *)
type extra = { covered : (Explored.t * Coverage.t) option; measured : Measured.t option }

let parameter_name (l : Loaded.t) =
  Option.map (fun (p : Scc_calculus.Open_number.t) -> p.parameter.name) l.parameter

let print_json console ~full ~where:shown_where loaded report verdicts extra code =
  let json =
    Check_json.document ~source:(Console.source console)
      {
        loaded;
        verdicts;
        where = shown_where;
        report;
        diagnostics = Console.kept console;
        exit = Exit_code.to_int code;
        full;
        cure =
          Scc_estimate.Cure.of_outcome loaded.model ~parameter:(parameter_name loaded) ~from:loaded.declared;
        coverage = extra.covered;
        measured = Option.map (fun m -> Measured.numbers m report) extra.measured;
      }
  in
  Json.pretty_pieces (Console.print console) json

let shows_zeno (o : Verdict.outcome) =
  List.exists (function Verdict.By One_instant -> true | By Dead_end | Among _ -> false) o.rests

let print_text console ~full ~where ~prove (loaded : Loaded.t) (report : Check.report) verdicts extra =
  let c = loaded.semantics in
  let print = Console.tell console in
  print (Scc_calculus.Parameters.line loaded.origin.settings ^ "\n\n");
  let parameter = parameter_name loaded in
  let property i v =
    let where = List.nth_opt where i in
    print (Check_text.property console ~full ?parameter ?where c ~from:loaded.declared v ^ "\n")
  in
  List.iteri property verdicts;
  let zeno w = if not (List.exists shows_zeno verdicts) then print (Check_text.zeno ~full c w ^ "\n") in
  Option.iter zeno report.zeno;
  Option.iter (fun t -> print (Check_text.zeno_left_out t ^ "\n")) report.left_out;
  print (Check_text.invariants ~asked:prove report);
  let causes = Check_text.causes loaded.model report.stats in
  print (Check_text.explored report.stats ^ causes ^ Check_text.slices report.slices);
  Option.iter (fun (space, c) -> print (Coverage_text.lines console space c)) extra.covered;
  print (Check_text.tally console verdicts);
  Option.iter (fun m -> List.iter (Console.note console) (Measured.lines m report)) extra.measured

let write_sarif console path code properties =
  let ok =
    match (code : Exit_code.t) with
    | Holds | Violated | Undecided | Invalid -> true
    | Stopped | Usage | Bug | Unwritten -> false
  in
  let json =
    Sarif.document ~source:(Console.source console) ~version:Version.current ~exit:(Exit_code.to_int code) ~ok
      ~faults:(Console.faults console) ~diagnostics:(Console.kept console) ~properties
  in
  write_file path (Json.pretty json)

let split_at n list = (List.filteri (fun i _ -> i < n) list, List.filteri (fun i _ -> i >= n) list)

(* All of the model, whether or not its properties were decided early. *)
let cover options reductions (l : Loaded.t) initial =
  let time_seen = Reduction.time_seen reductions l.model [] in
  Coverage.explore ~time_seen options l.semantics ~initial

let write_invariant console path (l : Loaded.t) (report : Check.report) =
  let text = function
    | By_invariant.Proved { invariant; _ } -> Invariant_text.to_string l.model invariant
    | None_found reason | Given_up reason -> Printf.sprintf "no invariant: %s\n" reason
  in
  let text = String.concat "\n" (List.map text report.invariants) in
  if not (String.equal path "-") then write_file path text
  else if Console.is_json console then Ok () (* the document has it *)
  else Ok (Console.tell console (text ^ "\n"))

(* The file to draw to, and what. *)
let view (extras : Check_extras.t) (l : Loaded.t) =
  match extras.draw with
  | None -> Ok None
  | Some path ->
    Scc_regions.Plane.view l.model.ranges ~axes:extras.axes ~fixed:extras.slice
    |> Result.map (fun view -> Some (path, view))
    |> Result.map_error (fun text -> [ Diag.error Code.bad_value Span.none "%s" text ])

let options console (budget : Budget.t) (extras : Check_extras.t) ~watch ~measured expanded =
  let states = Option.value budget.states ~default:Check_options.default_states in
  let compact = if extras.compact then Some states else None in
  let attempt = Measured.booking measured (Watch.attempt watch) in
  let parametric = Option.is_some extras.parametric in
  {
    (Check_options.starting ~attempt console watch budget) with
    reductions = (if parametric then Parametric_option.reductions else Fun.id) extras.reductions;
    order = extras.order; compact; prove = extras.prove; contrast = extras.contrast; curve = extras.curve;
    expanding = Expanded.expanding expanded; compacting = Expanded.compacting expanded;
  }

(* Each schedule is a file of its own. *)
let declare_witnesses console (extras : Check_extras.t) (l : Loaded.t) =
  let file folder (c : Scc_property.Property.check) =
    Outputs.file "a schedule of --witness" (Some (witness_file folder c))
  in
  Option.iter (fun folder -> Console.declare console (List.concat_map (file folder) l.checks)) extras.witness

(* Options that the model does not go with. *)
let fitting (extras : Check_extras.t) (l : Loaded.t) ~declared ~zones ~where =
  (* Coverage lists states one by one. *)
  let* () = if zones && extras.coverage then Result.map ignore (Ordinary.refuse l) else Ok () in
  let* () = Parametric_option.fitting l in
  let* () = Verdicts.refused l ~prove:extras.prove in
  let* () = Curve_output.refused l ~declared ~drawn:(Option.is_some extras.plot) extras.curve in
  if where then Ordinary.has_ranges l else Ok ()

(* Writes the files that were asked for. The code that the command ends with: a file that cannot be written is
   reported, and the others are written all the same. *)
let write_outputs console (extras : Check_extras.t) path (l : Loaded.t) report verdicts ~view expanded =
  let code = ref (exit_code report verdicts) in
  let output = function
    | Ok () -> ()
    | Error d ->
      Console.report console [ d ];
      code := Exit_code.worst [ !code; Unwritten ]
  in
  List.iter (fun d -> output (Error d)) (Expanded.close expanded);
  Option.iter (fun folder -> output (write_witnesses l path folder verdicts)) extras.witness;
  Option.iter (fun path -> output (write_sarif console path !code (Some (l.model, verdicts)))) extras.sarif;
  let title = Option.value l.origin.name ~default:"a model" in
  Option.iter (fun path -> output (write_file path (Curve_output.picture ~title verdicts))) extras.plot;
  let named = Drawn_checks.named verdicts report and ranges = l.model.ranges in
  let smt path =
    let claims, numbers = Drawn_checks.split ~name:(Printf.sprintf "%s-%s") verdicts named in
    output (write_file path (Scc_regions.Smt.script ranges ~numbers claims))
  in
  Option.iter smt extras.smt;
  Option.iter (fun path -> output (write_invariant console path l report)) extras.invariant;
  let draw (path, view) =
    let claims, values = Drawn_checks.split verdicts named in
    output (write_file path (Scc_regions.Drawing.svg ~values ranges view claims))
  in
  Option.iter draw view;
  !code

let read console (extras : Check_extras.t) (given : Options.definitions) path ~attempt =
  let parametric = Option.map (fun name -> { Scc_elaborate.Asked.name; attempt }) extras.parametric in
  Input.model ?parametric console ~overrides:given.values ~narrowed:given.narrowed path

let check console budget (extras : Check_extras.t) (given : Options.definitions) path =
  (* Coverage explores once more. *)
  let share = Option.map (fun s -> if extras.coverage then s /. 2. else s) budget.Budget.seconds in
  let watch = Check_options.watch { budget with seconds = share } in
  let measured = Measured.start () in
  let read ~attempt = read console extras given path ~attempt in
  let* l = Measured.phase measured "read" (fun () -> read ~attempt:0) in
  let declared = l.checks in
  let chosen l = Chosen_checks.only l extras.checks in
  let* l = chosen l in
  declare_witnesses console extras l;
  let zones = Verdicts.over_zones l in
  let where = extras.where || Option.is_some extras.smt || Option.is_some extras.draw in
  let* () = fitting extras l ~declared ~zones ~where in
  let* view = view extras l in
  Console.report console (l.warnings @ Vacuity.impossible l);
  let* initial = Loaded.initial l in
  let* () = if zones && Option.is_some extras.store then Expanded.no_sets else Ok () in
  let* expanded =
    let memory = Footprint.at_most (Check_options.words budget) in
    let explored = Check_extras.explored extras ~checks:l.checks budget in
    Expanded.openly console ~jobs:extras.jobs ~store:extras.store ~memory explored l
  in
  let options = options console budget extras ~watch ~measured expanded in
  (* What an invariant decides need not be explored: then nothing is known of premises. *)
  let premises = if extras.prove && not zones then [] else l.premises in
  let explore (l : Loaded.t) =
    let* initial = Loaded.initial l in
    let options = { options with parameter = l.parameter } in
    let run () =
      Expanded.guard expanded (fun () -> Verdicts.report options l ~initial ~exactly:where ~premises l.checks)
    in
    match (Watch.attempt watch).run Reporting run with
    | Ok report -> report
    | Error stop -> Ok (Check.unexplored options (l.checks @ premises) stop)
  in
  let load ~attempt = Result.bind (read ~attempt) chosen in
  let* l, report = Measured.phase measured "explore" (fun () -> Parametric_option.explored ~load l explore) in
  let* covered =
    if extras.coverage then begin
      Option.iter (Watch.more watch) share;
      let cover () = Ok (Some (cover options extras.reductions l initial)) in
      Measured.phase measured "coverage" (fun () -> Expanded.guard expanded cover)
    end
    else Ok None
  in
  Watch.finish watch;
  Console.progress_done console;
  List.iter (Console.fault console) (Check.faults report);
  let verdicts, answers = split_at (List.length l.checks) report.outcomes in
  Input.report console l
    (Parametric_option.at_value l (report.stats.faults @ report.stats.dead_ends)
     @ Vacuity.warnings report ~verdicts ~answers);
  let code = write_outputs console extras path l report verdicts ~view expanded in
  let shown = if extras.where then report.where else [] in
  let extra = { covered; measured = (if extras.stats then Some measured else None) } in
  if Console.is_json console then print_json console ~full:extras.full ~where:shown l report verdicts extra code
  else print_text console ~full:extras.full ~where:shown ~prove:extras.prove l report verdicts extra;
  Console.flush console;
  Ok code

(* A schedule is replayed with jumps: runs that stop at each step would not fit. *)
let unfit (extras : Check_extras.t) =
  Option.is_some extras.witness && not (List.exists (Reduction.equal Jump) extras.reductions)

let outputs (extras : Check_extras.t) =
  List.concat
    [
      Outputs.file "--sarif" extras.sarif; Outputs.file "--smt" extras.smt; Outputs.file "--draw" extras.draw;
      Outputs.file "--curve-plot" extras.plot; Outputs.file "--invariant" extras.invariant;
      Outputs.folder "--witness" extras.witness; Outputs.store extras.store;
    ]

let run color progress json budget (extras : Check_extras.t) given path =
  let console = Console.make ?progress ~color ~json () in
  if unfit extras then
    Guard.usage "--witness does not go with --no-reduce jump: schedules are replayed with jumps"
  else match Parametric_option.unfit extras with
    | Some option -> Guard.usage (option ^ " does not go with --parametric")
    | None ->
      Guard.run ~outputs:(outputs extras) console (fun () ->
          match check console budget extras given path with
          | Ok code -> Ok code
          | Error diagnostics ->
            let code = Guard.invalid console diagnostics in
            let is_about path (d : Diag.t) = String.equal d.span.file path in
            (match extras.sarif with
             | Some path when not (List.exists (is_about path) diagnostics) ->
               let written = write_sarif console path code None in
               Result.iter_error (fun d -> Console.report console [ d ]) written
             (* It is this file that could not be written. *)
             | Some _ | None -> ());
            Ok code)

let command =
  Cmd.v
    (Cmd.info "check" ~doc:"explore a model and verify its properties" ~man:Manual.check ~exits:(Exits.man ()))
    Term.(
      const run $ Options.color $ Options.progress $ Options.json $ Check_options.budget $ Check_extras.term
      $ Options.definitions $ Options.model_file)
