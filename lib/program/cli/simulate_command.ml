open Scc_exact
open Scc_loading
open Scc_verdicts
open Scc_simulate
open Scc_workers
open Cmdliner

type options = {
  path : string;
  given : (string * Rat.t) list;
  runs : int;
  seed : int64;
  jobs : int;
  memory : int option;
  part : Task_part.t option;
  observed : string list;
  every : Rat.t;
  until : Rat.t;
  steps : int option;
  summary : bool;
  quantiles : Rat.t list option;
  form : Report.form;
  decimals : int option;
  output : string option;
  resume : string option;
  store : string option;
  plot : string option;
  view : string option;
}

let quantiles_of o =
  let default = List.map (fun (n, d) -> Rat.make (Z.of_int n) (Z.of_int d)) [ (1, 20); (1, 2); (19, 20) ] in
  Option.value o.quantiles ~default

(* {1 The runs} *)

let plan o (l : Loaded.t) observables : Simulation.plan =
  {
    semantics = l.semantics;
    declared = l.declared;
    observables;
    times = Simulation.times ~every:o.every ~until:o.until;
    steps = o.steps;
  }

let report o (l : Loaded.t) observables times : Report.t =
  {
    form = o.form;
    digits = (match o.decimals with None -> Exactly | Some k -> Rounded k);
    origin = l.origin;
    seed = o.seed;
    observables = List.map (fun (o : Scc_export.Table.observable) -> o.text) observables;
    times;
  }

(* Seconds in which runs that are under way are to say what they have come to. *)
let patience = 5.

let each_run console o kept plan ~runs ~written ~first ~last ~room each =
  let progress show = show console (Printf.sprintf "%d of %d runs" !written runs) in
  let told _ (r : Simulation.run) =
    each r;
    if r.interrupted then Memory_of_runs.ended room;
    progress Console.progress
  in
  progress Console.phase;
  let interrupted () = Scc_system.Interruption.heard () || Memory_of_runs.over room in
  let work = Simulation.run plan ~seed:o.seed ~interrupted in
  let whole (r : Simulation.run) = not r.interrupted in
  let interrupted () = Memory_of_runs.stopped room in
  let result = Kept_runs.run kept ~patience ~whole ~jobs:o.jobs ~first ~count:last ~work ~interrupted ~each:told in
  Console.progress_done console;
  result

(* A run depends on these and its number alone. *)
let identity o (l : Loaded.t) =
  let options =
    [
      ("what is kept", "runs of scc simulate");
      ("--observe", String.concat "; " o.observed);
      ("--every", Rat.to_string o.every);
      ("--until", Rat.to_string o.until);
      ("--steps, by instants", Option.fold ~none:"default" ~some:string_of_int o.steps);
      ("--seed", Int64.to_string o.seed);
    ]
  in
  let { Origin.digest; parameters; _ } = l.origin in
  Kept.identity ~digest ~parameters options

let early console ~steps n =
  let cure = if Option.is_some steps then "; without `--steps` a run goes on to that time, if it can" else "" in
  if n > 0 then
    Console.note console
      (Printf.sprintf "scc: %s did not come to the last time; what was not observed is empty%s"
         (Scc_base.Plural.count n "run" "runs") cure)

let conclude console ~room ~steps ~runs ~finished ~partly ~ended_early result =
  match if partly > 0 then Error Pool.Interrupted else result with
  | Ok () ->
    early console ~steps ended_early;
    Ok (if ended_early > 0 then Exit_code.Undecided else Exit_code.Holds)
  | Error stop ->
    (match (stop : Pool.stop) with Interrupted -> early console ~steps ended_early | Lost _ -> ());
    let why = Memory_of_runs.reason room in
    Ok (Kept_runs.stopped console ~why ~what:"run" ~partly ~written:finished ~count:runs stop)

let in_all o = o.summary || Option.is_some o.plot || Option.is_some o.view

(* What is gone on with: how many runs there are, as text, and as runs where something is told of all of them. *)
let before console o report =
  let exact = if in_all o then { report with Report.form = Jsonl; digits = Exactly } else report in
  match o.resume with
  | None -> Ok (0, Report.header report, [])
  | Some path ->
    let* n, text = Resume.lines console ~path ~header:(Report.header exact) ~member:"run" ~what:"simulation" in
    let rec read k found = function
      | line :: rest when k < min n o.runs -> (
          match Report.read line with
          | Some r -> read (k + 1) (r :: found) rest
          | None -> Resume.bad path "line %d is no run" (k + 2))
      | _ -> Ok (List.rev found)
    in
    let* runs = if in_all o then read 0 [] (List.tl (String.split_on_char '\n' text)) else Ok [] in
    Ok (n, text, runs)

let simulate console o ~says_more ~room =
  let* model = Input.model console ~overrides:o.given ~narrowed:[] o.path in
  let* () = Ordinary.at_point ~otherwise:"`scc trace --start simple` chooses them" model in
  Watch.has_read (Memory_of_runs.watch room);
  Console.report console model.warnings;
  let* loaded, observables = Observed.all console model o.observed in
  let plan = plan o loaded observables in
  if o.form = Csv && says_more then
    Option.iter (fun line -> Console.note console ("scc: " ^ line)) (Scc_elaborate.Lattices.line model.lattices);
  let report = report o model observables plan.times in
  let* there, before, earlier = before console o report in
  let from, last = Task_part.range o.part ~count:o.runs in
  let first = max there from in
  let path = if o.summary then o.output else Resume.file ~output:o.output ~resume:o.resume in
  let* kept = Kept_runs.openly console ~folder:o.store ~identity:(identity o model) "the runs" in
  let written = ref there and ended_early = ref 0 and partly = ref 0 in
  let all = ref (Report.nobody report) and page = Simulation_page.create plan in
  let add (r : Simulation.run) =
    if Option.is_some r.ended then incr ended_early;
    if Option.is_some o.view then Simulation_page.add page r;
    if in_all o then all := Report.add !all r
  in
  List.iter add earlier;
  let write put =
    if not o.summary then put before;
    let result =
      each_run console o kept plan ~runs:(last - from) ~written ~first ~last ~room (fun r ->
          incr (if r.interrupted then partly else written);
          add r;
          if not o.summary then put (Report.run report r))
    in
    if o.summary then
      Report.summary report ~quantiles:(quantiles_of o) ~decimals:(Option.value o.decimals ~default:6) !all put;
    result
  in
  let draw path =
    let chart put = put (Plot.chart report ~quantiles:(quantiles_of o) !all) in
    Result.listed (Console.with_output console ~path:(Some path) chart)
  in
  let view path =
    let interrupted () = Memory_of_runs.stopped room in
    let name = Filename.basename o.path in
    Simulation_page.write page console loaded ~path ~name ~report ~asked:(last - from) ~first:from ~summary:!all
      ~interrupted
  in
  Console.flush console;
  match Console.with_main_output console ~pieces:(not o.summary) ~path write with
  | None, failed -> Result.map (fun () -> Exit_code.Holds) (Result.listed failed)
  | Some result, table ->
    let plot = Option.fold ~none:(Ok ()) ~some:draw o.plot in
    let page = Option.fold ~none:(Ok true) ~some:view o.view in
    let others = Guard.unwritten console [ Result.listed table; plot; Result.map ignore page ] in
    let cut : Exit_code.t = match page with Ok false -> Stopped | Ok true | Error _ -> Holds in
    let runs = last - from and finished = !written and partly = !partly and ended_early = !ended_early in
    let* code = conclude console ~room ~steps:o.steps ~runs ~finished ~partly ~ended_early result in
    Ok (Kept_runs.finish console kept (Exit_code.worst [ code; cut; others ]))

let outputs o =
  List.concat
    [
      Outputs.file ~over:o.resume "-o" (Resume.file ~output:o.output ~resume:o.resume);
      Outputs.file "--plot" o.plot; Outputs.file "--view" o.view; Outputs.store o.store;
    ]

let run color progress o =
  let console = Console.make ?progress ~color ~json:false () in
  let room = Memory_of_runs.start ~memory:o.memory ~jobs:o.jobs () in
  Scc_base.Memory.spare_runs ();
  Guard.run ~outputs:(outputs o) console (fun () -> simulate console o ~says_more:(Option.is_some progress) ~room)

(* {1 The command line} *)

let runs =
  let doc = "How many runs, from number 0 on." in
  let number = Options.integer ~least:1 "positive number of runs" in
  Arg.(required & opt (some number) None & info [ "runs" ] ~docv:"N" ~doc)

let observed =
  let doc =
    "Observes $(docv), any number or predicate of a state that a check can name; a predicate is 1 or 0. May be \
     given several times."
  in
  Arg.(non_empty & opt_all string [] & info [ "observe" ] ~docv:"FORMULA" ~doc)

let every =
  let doc = "Observes at the multiples of $(docv), and at the end." in
  Arg.(required & opt (some (Options.positive "step")) None & info [ "every" ] ~docv:"STEP" ~doc)

let until =
  let doc = "Runs end at the model time $(docv); 0 is their first instant." in
  Arg.(required & opt (some (Options.not_negative "model time")) None & info [ "until" ] ~docv:"TIME" ~doc)

let steps =
  Options.maybe Options.transitions [ "steps" ] ~docv:"N"
    "Ends a run after $(docv) transitions; the draws and lots of one instant count as one."

let summary =
  Options.flag [ "summary" ]
    "Summarises all runs, for each time and observable: the number of runs with a value, mean, variance of the \
     sample, standard deviation, least, quantiles and greatest. All are exact except the deviation, which is \
     rounded to $(b,--decimals), or 6."

let quantiles =
  let doc =
    "The quantiles of $(b,--summary) and $(b,--plot), by the nearest rank. The default is 1/20,1/2,19/20."
  in
  Arg.(value & opt (some (list (Options.not_negative "quantile"))) None & info [ "quantiles" ] ~docv:"Q,..." ~doc)

let plot =
  Options.maybe Options.named [ "plot" ] ~docv:"FILE"
    "Draws a chart, as SVG: for each observable the mean over the time, and the range from the first to the \
     last of $(b,--quantiles)."

let view =
  Options.maybe Options.named [ "view" ] ~docv:"FILE"
    "Writes a page that shows the first 20 runs, or fewer if they are large, as $(b,scc view) does. It has the \
     distribution of each observable over all runs, at each time."

let form =
  Options.default (Arg.enum [ ("csv", Report.Csv); ("jsonl", Jsonl) ]) Report.Csv [ "format" ] ~docv:"FORMAT"
    "$(b,csv) (RFC 4180), or $(b,jsonl), a JSON object a line."

let decimals =
  Options.maybe (Options.integer ~least:0 ~most:1000 "number of decimals") [ "decimals" ] ~docv:"K"
    "Writes numbers rounded to $(docv) decimals, instead of exactly as texts $(b,p/q)."

let resume =
  Options.maybe Options.named [ "resume" ] ~docv:"FILE"
    "Continues $(docv), written with $(b,--format jsonl) by a simulation that was interrupted, or had fewer \
     runs; an unfinished line is made anew. All options except $(b,--runs) and $(b,--jobs) must be the same. The \
     file, or $(b,-o), becomes what it would be without an interruption. The exit code is about the new runs. \
     $(b,--summary) does not change the file, and summarises its runs together with the new ones, as $(b,--plot) \
     does; the numbers of the file must be exact."

let store_option =
  Kept.option
    ~doc:
      "Stores the runs in the folder $(docv), which is created if necessary, while they are made. The same \
       command resumes, and so does one with another $(b,--runs) or $(b,--jobs), or with another output of the \
       same runs ($(b,--format), $(b,--summary), $(b,--plot), $(b,--view)). See STORES."

let fitting o =
  if Simulation.too_many ~every:o.every ~until:o.until then
    Error (Printf.sprintf "--every and --until make more than %d times" Simulation.most_times)
  else if List.exists (fun q -> Rat.compare q Rat.one > 0) (quantiles_of o) then Error "a quantile is not above 1"
  else if Option.is_some o.quantiles && (not o.summary) && Option.is_none o.plot then
    Error "--quantiles are those of --summary or --plot: neither is given"
  else if Option.is_some o.view && Option.is_some o.resume then
    Error "--view and --resume do not go together: with --store, the same command resumes and writes the page"
  else
    let too_large _ =
      let times = Array.length (Simulation.times ~every:o.every ~until:o.until) in
      Simulation_page.too_large ~times ~observables:(List.length o.observed)
    in
    let view = Option.bind o.view too_large in
    let lines = o.form <> Csv || o.summary in
    let conflict = Resume.conflict ~resume:o.resume ~store:o.store ~part:o.part ~lines in
    match ((if Option.is_some view then view else conflict), o.resume) with
    | Some text, _ -> Error text
    | None, Some _ when Option.is_some o.decimals && Option.is_some o.plot && not o.summary ->
      Error "--resume with --decimals does not go with --plot, which takes exact numbers"
    | None, _ -> Ok o

let options =
  let make path given runs seed jobs memory part observed every until steps summary quantiles form decimals output
      resume store plot view =
    fitting
      {
        path; given; runs; seed; jobs; memory; part; observed; every; until; steps; summary; quantiles; form;
        decimals;
        output; resume; store; plot; view; }
  in
  Term.(
    term_result' ~usage:true
      (const make $ Options.model_file $ Options.overrides $ runs $ Run_options.seed $ Run_options.jobs
       $ Check_options.memory () $ Task_part.option ~what:"runs" $ observed $ every $ until $ steps
       $ summary $ quantiles $ form $ decimals
       $ Options.output "Writes to $(docv) instead of standard output." $ resume $ store_option $ plot $ view))

let command =
  let told =
    [
      (Exit_code.Holds, "if all runs came to the last time.");
      (Exit_code.Undecided, "if some run was over before.");
      ( Exit_code.Stopped,
        "if it was interrupted, or met the limit of --memory: the runs are written as far as they came." );
    ]
  in
  let exits = Exits.man ~told ~never:[ Violated ] () in
  let doc = "make many runs of a model, and write what is observed" in
  let info = Cmd.info "simulate" ~doc ~man:Manual.simulate ~exits in
  Cmd.v info Term.(const run $ Options.color $ Options.progress $ options)
