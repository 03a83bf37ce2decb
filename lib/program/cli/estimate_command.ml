open Scc_base
open Scc_exact
open Scc_loading
open Scc_verdicts
open Scc_estimate
open Scc_workers
open Cmdliner

type options = {
  path : string;
  given : (string * Rat.t) list;
  checks : string list;
  properties : string list;
  how : Estimate_options.t;
  seconds : float option;
  jobs : int;
  memory : int option;
  store : string option;
  levels : string option;
  effort : int option;
  elsewhere : bool;  (** others make the runs *)
  make : Runs_elsewhere.wanted option;  (** these runs, for another process *)
}

(* {1 What is asked} *)

let properties console l texts =
  Observed.questions console l texts ~name:(fun i _ -> Printf.sprintf "<property %d>" (i + 1))
    (fun i _ question ~refuse ->
       match question with
       | Temporal check -> Ok { check with name = Printf.sprintf "property%d" (i + 1) }
       | State _ | Number _ ->
         refuse Code.type_mismatch ~hint:"as in `P = ? [ eventually f ]`, `E = ? [ x(p) at 10 ]`"
           "this is about states, and asks for no probability and no mean")

(* {1 The runs} *)

type ending = Whole | Interrupted | Lost of { why : string; fault : bool }

(* Seconds in which runs that are under way are to say what they have come to. *)
let patience = 5.

let answered estimation ~count =
  match List.length (Estimation.answers estimation) with
  | 0 -> ""
  | known -> Printf.sprintf ", %d of %d answered" known count

let is_over room () = Scc_system.Interruption.heard () || Memory_of_runs.over room

let sample console o runs ~turn (plan : Sample.plan) estimation ~room ~stopped =
  let work = Sample.run plan ~seed:o.how.seed ~interrupted:(is_over room) in
  let whole (r : Sample.run) = not r.interrupted in
  let stop () =
    Estimation.judge estimation ~last:true;
    Interrupted
  in
  Console.phase console "making runs";
  let rec go first =
    match Estimation.next estimation with
    | None -> Whole
    | Some count -> (
        let each k (outcome : Sample.run) =
          if outcome.interrupted then Memory_of_runs.ended room;
          let answered = answered estimation ~count:(List.length plan.paths) in
          Console.progress console (Printf.sprintf "%d runs%s" (k + 1) answered);
          Estimation.add estimation outcome
        in
        let made =
          Kept_runs.run runs ~patience ~whole ~turn ~jobs:o.jobs ~first ~count ~work ~interrupted:stopped ~each
        in
        match made with
        | Ok () ->
          Estimation.judge estimation ~last:false;
          go count
        | Error Pool.Interrupted -> stop ()
        | Error (Lost { task; how; fault }) ->
          Estimation.judge estimation ~last:true;
          Lost { why = Kept_runs.lost ~what:"run" ~task ~how; fault })
  in
  let ending = if stopped () then stop () else go 0 in
  Console.progress_done console;
  ending

(* The questions of each turn. Turn 0 has all of them. *)
let turns (plan : Sample.plan) = List.mapi (fun k paths -> (k + 1, paths)) (Sequence.in_turn plan.paths)

let sample_all console o runs (plan : Sample.plan) aim ~room =
  let stopped () = Memory_of_runs.stopped room in
  let one (answers, ending) (turn, paths) =
    let estimation = Estimation.start aim paths in
    let stopped () = ending <> Whole || stopped () in
    let next = sample console o runs ~turn { plan with paths } estimation ~room ~stopped in
    (answers @ Estimation.answers estimation, if ending = Whole then next else ending)
  in
  (* Stored runs are those of all questions. *)
  let turns = if Option.is_some o.store then [ (0, plan.paths) ] else turns plan in
  let answers, ending = List.fold_left one ([], Whole) turns in
  let of_path p = List.find_opt (fun (a : Estimation.answer) -> a.path == p) answers in
  (List.filter_map of_path plan.paths, ending)

(* {1 Rare events} *)

let default_repetitions = 100
let default_steps = 10_000

let split console o runs (plan : Splitting.plan) ~room =
  let stopped () = Memory_of_runs.stopped room in
  let work = Splitting.repeat plan ~seed:o.how.seed ~interrupted:(is_over room) in
  let whole (r : Splitting.repetition) = not r.interrupted in
  let made = ref [] in
  let each k (repetition : Splitting.repetition) =
    if repetition.interrupted then Memory_of_runs.ended room;
    Console.progress console (Printf.sprintf "%d repetitions" (k + 1));
    made := repetition :: !made
  in
  let count = Option.value o.how.runs ~default:default_repetitions in
  let result = Kept_runs.run runs ~patience ~whole ~jobs:o.jobs ~first:0 ~count ~work ~interrupted:stopped ~each in
  Console.progress_done console;
  let ending =
    match result with
    | Ok () -> Whole
    | Error Pool.Interrupted -> Interrupted
    | Error (Lost { task; how; fault }) -> Lost { why = Kept_runs.lost ~what:"repetition" ~task ~how; fault }
  in
  (List.rev !made, ending)

let default_effort = 100
let effort o = Option.value o.effort ~default:default_effort

(* A run depends on these and its number alone: how many there are, and what is made of them, may change. *)
let identity o (l : Loaded.t) (paths : Path.t list) =
  let free = match o.how.free with Sample.Apart -> "apart" | Evenly -> "evenly" in
  let options =
    [
      ("what is kept", "runs of scc estimate");
      ("what is estimated", Scc_verify.Joint_check.about (List.map (fun (p : Path.t) -> p.check) paths));
      ("--free", free);
      ("--steps", Option.fold ~none:"default" ~some:string_of_int o.how.steps);
      ("--until", Option.fold ~none:"default" ~some:Rat.to_string o.how.until);
      ("--seed", Int64.to_string o.how.seed);
    ]
    @ Option.fold ~none:[]
      ~some:(fun levels -> [ ("--levels", levels); ("--effort", string_of_int (effort o)) ])
      o.levels
  in
  let { Origin.digest; parameters; _ } = l.origin in
  Kept.identity ~digest ~parameters options

(* {1 The report} *)

let style : Estimation.verdict -> Console.style = function
  | Holds -> Good
  | Violated -> Bad
  | Undecided -> Doubtful
  | Sampled -> Doubtful
  | Estimated -> Strong

let text console lattices (r : Estimate_report.t) =
  let answer (a : Estimation.answer) =
    let verdict = Console.styled console (style a.verdict) (Estimate_report.word a) in
    let line = Estimate_report.line a ~confidence:r.aim.confidence in
    let even =
      if a.chosen && a.verdict <> Undecided then [ "  choices that nothing draws were taken evenly" ] else []
    in
    let below = List.map (fun text -> "  " ^ text) (Estimate_report.of_known a @ a.reasons) in
    String.concat "\n" (((a.path.check.name ^ ": " ^ verdict ^ ": " ^ line) :: even) @ below) ^ "\n"
  in
  let reasons = List.sort_uniq String.compare (List.map snd r.left_out) in
  let left why =
    let names = List.filter_map (fun (name, w) -> if String.equal w why then Some name else None) r.left_out in
    Console.styled console Faint ("left out: " ^ String.concat ", " names ^ ": " ^ why) ^ "\n"
  in
  let lattice = Option.to_list (Option.map (fun line -> line ^ "\n") (Scc_elaborate.Lattices.line lattices)) in
  String.concat "\n" (lattice @ List.map answer r.answers @ List.map left reasons)

let exit_code answers ending : Exit_code.t =
  match ending with
  | Whole -> Exit_code.worst (List.map Estimate_report.exit_code answers)
  | Interrupted -> Stopped
  | Lost { fault; _ } -> Kept_runs.loss ~fault

(* Runs for another process: as many as it wants. *)
let make console o loaded paths ~identity ~room (wanted : Runs_elsewhere.wanted) =
  let of_ = Runs_elsewhere.digest identity and seed = o.how.seed and interrupted = is_over room in
  let ending made = if made then Ok Exit_code.Holds else Ok (Guard.stopped console "a run was ended by a limit") in
  match o.levels with
  | Some text ->
    let steps = Option.value o.how.steps ~default:default_steps in
    let* _, plan = Levels.plan console loaded paths text ~effort:(effort o) ~steps in
    let whole (r : Splitting.repetition) = not r.interrupted in
    ending (Runs_elsewhere.make wanted ~of_ ~whole (Splitting.repeat plan ~seed ~interrupted))
  | None -> (
      let plan = Estimate_options.plan o.how loaded paths in
      match List.assoc_opt wanted.turn ((0, plan.paths) :: turns plan) with
      | None -> Ok (Guard.usage (Printf.sprintf "--make: there is no turn %d" wanted.turn))
      | Some paths ->
        let whole (r : Sample.run) = not r.interrupted in
        ending (Runs_elsewhere.make wanted ~of_ ~whole (Sample.run { plan with paths } ~seed ~interrupted)))

let opened console o ~identity about =
  let of_ = Runs_elsewhere.digest identity in
  let elsewhere = if o.elsewhere then Some (Runs_elsewhere.start ~of_) else None in
  Kept_runs.openly ?elsewhere console ~folder:o.store ~identity about

let by_runs console o (loaded : Loaded.t) paths aim ~identity ~room =
  let plan = Estimate_options.plan o.how loaded paths in
  let* runs = opened console o ~identity "the runs" in
  let answers, ending = sample_all console o runs plan aim ~room in
  Ok (answers, ending, Kept_runs.close runs)

let by_splitting console o loaded paths text ~identity ~room =
  let steps = Option.value o.how.steps ~default:default_steps in
  let* path, plan = Levels.plan console loaded paths text ~effort:(effort o) ~steps in
  let* runs = opened console o ~identity "the repetitions" in
  let made, ending = split console o runs plan ~room in
  let summary = Splitting.summary plan made ~confidence:o.how.confidence in
  Ok (Option.to_list (Option.map (Estimation.of_splitting path) summary), ending, Kept_runs.close runs)

let judged console o room (model : Loaded.t) loaded paths left_out ~identity =
  let aim = Estimate_options.aim o.how in
  let* answers, ending, unkept =
    match o.levels with
    | Some text -> by_splitting console o loaded paths text ~identity ~room
    | None -> by_runs console o loaded paths aim ~identity ~room
  in
  let exit = Exit_code.worst (exit_code answers ending :: Kept.code unkept) in
  let report =
    {
      Estimate_report.origin = model.origin;
      aim;
      seed = o.how.seed;
      answers;
      left_out;
      interrupted = (match ending with Whole -> false | Interrupted | Lost _ -> true);
      source = Console.source console;
      diagnostics = Console.kept console;
    }
  in
  Console.answer console
    ~json:(fun () -> Scc_json.Json_format.write Estimate_report.format (report, exit))
    ~text:(fun () -> text console model.lattices report);
  Kept.conclude console unkept;
  (match ending with
   | Whole -> ()
   | Interrupted ->
     let why = Memory_of_runs.reason room in
     Console.note console ("scc: " ^ why ^ "; what is said rests on the runs that were made")
   | Lost { why; _ } -> Console.note console ("scc: " ^ why ^ "; what is said rests on the runs that were made"));
  Ok exit

let estimate console o room =
  let* model = Input.model console ~overrides:o.given ~narrowed:[] o.path in
  let* () = Ordinary.at_point ~otherwise:"`scc trace --start simple` chooses them" model in
  Watch.has_read (Memory_of_runs.watch room);
  Console.report console model.warnings;
  let* loaded, added = properties console model o.properties in
  let by_name = o.checks <> [] || added <> [] in
  let* named = Chosen_checks.of_names loaded o.checks in
  let asked = if by_name then named @ added else model.checks in
  let* paths, left_out = Estimate_options.paths model asked ~by_name in
  let identity = identity o model paths in
  match o.make with
  | Some wanted -> make console o loaded paths ~identity ~room wanted
  | None -> judged console o room model loaded paths left_out ~identity

let run color progress json o =
  let console = Console.make ?progress ~color ~json () in
  let room = Memory_of_runs.start ?seconds:o.seconds ~memory:o.memory ~jobs:o.jobs () in
  Guard.run ~outputs:(Outputs.store o.store) console (fun () -> estimate console o room)

(* {1 The command line} *)

let checks = Chosen_checks.option ~doc:"Estimates only the check $(docv). May be given several times."

let properties =
  Options.repeated Arg.string [ "property" ] ~docv:"PROPERTY"
    "Estimates $(docv), a property that is not in the model: $(b,P = ? [ eventually f ]). May be given several \
     times."

let store_option =
  Kept.option
    ~doc:
      "Stores the runs in the folder $(docv), which is created if necessary, while they are made. The same \
       command resumes, and so does one with another $(b,--runs), $(b,--most), $(b,--confidence), $(b,--width), \
       $(b,--seconds) or $(b,--jobs). See STORES."

let levels =
  Options.maybe Arg.string [ "levels" ] ~docv:"LEVELS"
    "Estimates a rare event by splitting, at the levels of $(docv): $(b,'x\\(p\\) >= 1, 2, 3') or \
     $(b,'x\\(p\\) >= 1..9'). See RARE EVENTS."

let effort =
  Options.maybe Estimate_options.count [ "effort" ] ~docv:"N"
    "With $(b,--levels), makes $(docv) runs from each level in each repetition. The default is 100."

let elsewhere =
  Options.flag [ "elsewhere" ]
    "Makes no runs: asks for them on standard output, and reads them from standard input. See RUNS MADE ELSEWHERE."

let make_option =
  Options.maybe Runs_elsewhere.conv [ "make" ] ~docv:"TURN:FROM-TO"
    "Makes only these runs, for $(b,scc estimate --elsewhere), and writes them. See RUNS MADE ELSEWHERE."

let options =
  let make path given checks properties how seconds jobs memory store levels effort elsewhere make =
    let { Estimate_options.most; width; free; until; normal; _ } = how in
    if Option.is_some levels && (Option.is_some until || free = Sample.Evenly) then
      Error "--levels cannot be combined with --until or --free evenly: write `within` in the property"
    else if Option.is_some levels && (Option.is_some most || Option.is_some width) then
      Error "--levels cannot be combined with --most or --width: --runs says how many repetitions are made"
    else if normal && Option.is_some levels then Error "--normal is about means, and --levels about probabilities"
    else if Option.is_some effort && Option.is_none levels then
      Error "--effort is the number of runs from each level: it needs --levels"
    else if Option.is_some make && (elsewhere || Option.is_some store) then
      Error "--make writes runs, and cannot be combined with --elsewhere or --store"
    else if elsewhere && String.equal path "-" then
      Error "with --elsewhere the model cannot be read from standard input, which is for runs"
    else Ok { path; given; checks; properties; how; seconds; jobs; memory; store; levels; effort; elsewhere; make }
  in
  Term.(
    term_result' ~usage:true
      (const make $ Options.model_file $ Options.overrides $ checks $ properties $ Estimate_options.term
       $ Run_options.seconds $ Run_options.jobs $ Check_options.memory () $ store_option $ levels $ effort
       $ elsewhere $ make_option))

let command =
  let told =
    [
      (Exit_code.Holds, "if every comparison is estimated to hold, and every number is estimated. No proof.");
      (Exit_code.Violated, "if some comparison is estimated to be violated.");
      ( Exit_code.Undecided,
        "if some property is undecided, or sampled as a mean without a range, or some interval is wider than \
         requested." );
      (Exit_code.Stopped, "if it was stopped: the answers rest on the runs that were made.");
    ]
  in
  let exits = Exits.man ~told () in
  let info = Cmd.info "estimate" ~doc:"tell probabilities and means from many runs" ~man:Manual.estimate ~exits in
  Cmd.v info Term.(const run $ Options.color $ Options.progress $ Options.json $ options)
