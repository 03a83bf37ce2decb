open Scc_base
open Scc_verify
open Scc_loading
open Scc_verdicts
open Scc_estimate
open Scc_sweep
open Cmdliner

type form = Csv | Jsonl

type options = {
  path : string;
  grid : Grid.t;
  checks : string list;
  budget : Budget.t;
  jobs : int;
  part : Task_part.t option;
  form : form;
  decimals : int option;
  output : string option;
  resume : string option;
  store : string option;
  plot : string option;
  estimated : Estimate_options.t option;
}

(* {1 One point} *)

(* In a process of its own, and by itself: as `scc check` with these values. *)
let check o source k =
  let console = Console.make ~color:Console.Never ~json:true () in
  let watch = Check_options.watch ~signals:false ~jobs:o.jobs o.budget in
  let options = Check_options.options ~jobs:o.jobs watch o.budget ~progress:ignore in
  let found =
    let* l = Input.model console ~source ~overrides:(Grid.point o.grid k) ~narrowed:[] o.path in
    let* l = Chosen_checks.only l o.checks in
    let* () = Verdicts.refused l ~prove:false in
    let* initial = Loaded.initial l in
    let run () = Verdicts.report options l ~initial ~exactly:false ~premises:l.premises l.checks in
    let* report =
      match (Watch.attempt watch).run Reporting run with
      | Ok report -> report
      | Error stop -> Ok (Check.unexplored options (l.checks @ l.premises) stop)
    in
    Ok (l.lattices, List.filteri (fun i _ -> i < List.length l.checks) report.outcomes)
  in
  Watch.finish watch;
  match found with
  | Ok (lattices, outcomes) -> Outcome.of_outcomes ~lattices outcomes
  | Error diagnostics -> Outcome.of_diagnostics diagnostics

(* As `scc estimate` with these values, by one run after the other. *)
let estimate o (how : Estimate_options.t) source k =
  let console = Console.make ~color:Console.Never ~json:true () in
  let watch = Check_options.watch ~signals:false ~jobs:o.jobs o.budget in
  let stopped () = Option.is_some (Watch.stop watch ()) in
  let found =
    let* l = Input.model console ~source ~overrides:(Grid.point o.grid k) ~narrowed:[] o.path in
    let* () = Ordinary.at_point ~otherwise:"`scc trace --start simple` chooses them" l in
    let* chosen = Chosen_checks.only l o.checks in
    let* paths, _ = Estimate_options.paths l chosen.checks ~by_name:(o.checks <> []) in
    let plan = Estimate_options.plan how l paths in
    Ok (l.lattices, Sequence.answers (Estimate_options.aim how) plan ~seed:how.seed ~stopped)
  in
  let stopped = stopped () in
  Watch.finish watch;
  match found with
  | Ok (lattices, answers) -> Outcome.of_answers ~lattices ~stopped answers
  | Error diagnostics -> Outcome.of_diagnostics diagnostics

let work o = match o.estimated with None -> check o | Some how -> estimate o how

(* {1 All of them} *)

let bounds (b : Budget.t) =
  let some name text = Option.fold ~none:[] ~some:(fun x -> [ (name, text x) ]) in
  List.concat
    [
      some "depth" string_of_int b.depth; some "time" Scc_exact.Rat.to_string b.time;
      some "states" string_of_int b.states; some "seconds" (Printf.sprintf "%g") b.seconds;
      some "memory" string_of_int b.memory; some "bits" string_of_int b.bits;
    ]

(* What can be estimated is so at every point. *)
let left_out console o (l : Loaded.t) =
  let note (name, why) = Console.note console (Printf.sprintf "scc: left out: %s: %s" name why) in
  Estimate_options.paths l l.checks ~by_name:(o.checks <> [])
  |> Result.map (fun (_, left) -> List.iter note left)

(* A fault of the command line is one at every point. Warnings are those of the first point alone. *)
let first_point console source o =
  let read () =
    let* l = Input.model console ~source ~overrides:(Grid.point o.grid 0) ~narrowed:[] o.path in
    Chosen_checks.only l o.checks
  in
  match read () with
  | Ok l ->
    Console.report console l.warnings;
    let* () = if Option.is_some o.estimated then left_out console o l else Ok () in
    Ok (Some l)
  | Error diagnostics when List.exists (fun (d : Diag.t) -> Span.equal d.span Span.command_line) diagnostics ->
    Error diagnostics
  | Error _ -> Ok None

(* Seen in the text, so that all points have the same columns. *)
let diffuses source =
  Result.fold ~ok:Scc_elaborate.Laws.some_diffuse ~error:(fun _ -> false) (Scc_notation.Notation.model source)

type seen = {
  mutable written : int;
  mutable open_ : int;
  mutable refused : int;
  mutable stopped : int;
  kicks : Kicks.t;
  mutable all : Outcome.t list;  (** the last first, if there is to be a picture *)
}

let conclude console seen ~count = function
  | Ok () ->
    Option.iter (Console.note console) (Kicks.conclusion seen.kicks);
    if seen.refused > 0 then
      Console.note console (Printf.sprintf "scc: the model is invalid at %d of %d points" seen.refused count);
    if count > 0 && seen.refused = count then Ok Exit_code.Invalid
    else if seen.stopped > 0 then begin
      Console.note console
        (Printf.sprintf "scc: a limit of seconds or memory left something open at %d of %d points"
           seen.stopped count);
      Ok Exit_code.Stopped
    end
    else Ok (if seen.open_ + seen.refused > 0 then Exit_code.Undecided else Exit_code.Holds)
  | Error stop -> Ok (Kept_runs.stopped console ~what:"point" ~written:seen.written ~count stop)

(* A point depends on these and its number alone. *)
let identity o ~digest =
  let axis (a : Grid.axis) =
    ("-D " ^ a.name, String.concat "," (List.map Scc_exact.Rat.to_string (Array.to_list a.values)))
  in
  let bound name = ("--" ^ name, Option.value (List.assoc_opt name (bounds o.budget)) ~default:"default") in
  let options =
    (("what is kept", "points of scc sweep") :: List.map axis o.grid)
    @ (match o.checks with [] -> [] | names -> [ ("--check", String.concat ", " names) ])
    @ List.map bound [ "depth"; "time"; "states"; "seconds"; "memory"; "bits" ]
    @ match o.estimated with None -> [] | Some how -> ("--estimate", "") :: Estimate_options.described how
  in
  Kept.identity ~digest ~parameters:[] options

let note console o seen k outcome =
  seen.written <- seen.written + 1;
  (match (outcome : Outcome.t) with
   | Refused _ -> seen.refused <- seen.refused + 1
   | Checked _ -> if not (Outcome.is_known outcome) then seen.open_ <- seen.open_ + 1);
  if Outcome.is_stopped outcome then seen.stopped <- seen.stopped + 1;
  List.iter (Console.fault console) (Outcome.faults outcome);
  Option.iter (fun d -> Console.report console [ d ]) (Kicks.add seen.kicks k (Outcome.lattices outcome));
  if Option.is_some o.plot then seen.all <- outcome :: seen.all

let sweep console o watch =
  let interrupted = Watch.interrupted watch in
  let* source = Input.warned console o.path in
  let* first = first_point console source o in
  Watch.has_read watch;
  let name, digest =
    match first with
    | Some l -> Table.origin l.origin
    | None -> (None, "md5:" ^ Digest.to_hex (Digest.string (Source.text source)))
  in
  let { grid; checks; decimals; _ } = o and bounds = bounds o.budget in
  let estimated = Option.map Estimate_options.described o.estimated in
  let table = { Table.name; digest; grid; bounds; checks; decimals; diffuses = diffuses source; estimated } in
  let from, last = Task_part.range o.part ~count:(Z.to_int (Grid.size o.grid)) in
  let count = last - from in
  let* there, before =
    match o.resume with
    | None -> Ok (0, match o.form with Csv -> Table.csv_header table | Jsonl -> Table.json_header table)
    | Some path -> Resume.lines console ~path ~header:(Table.json_header table) ~member:"point" ~what:"sweep"
  in
  let* points = Kept_runs.openly console ~folder:o.store ~identity:(identity o ~digest) "the points" in
  let path = Resume.file ~output:o.output ~resume:o.resume in
  let kicks = Kicks.start (Option.fold ~none:[] ~some:(fun (l : Loaded.t) -> l.lattices) first) in
  let seen = { written = there; open_ = 0; refused = 0; stopped = 0; kicks; all = [] } in
  let write put =
    put before;
    let progress show = show console (Printf.sprintf "%d of %d points" seen.written count) in
    progress Console.phase;
    let each k outcome =
      note console o seen k outcome;
      progress Console.progress;
      put (match o.form with Csv -> Table.csv table k outcome | Jsonl -> Table.json table k outcome)
    in
    let first = max there from in
    let result =
      Kept_runs.run points ~jobs:o.jobs ~first ~count:last ~work:(work o source) ~interrupted ~each
    in
    Console.progress_done console;
    result
  in
  Console.flush console;
  let made, table = Console.with_main_output console ~pieces:true ~path write in
  let title = Option.value name ~default:"a model" in
  let draw path =
    let chart put = put (Picture.chart ~title o.grid (Array.of_list (List.rev seen.all))) in
    Result.listed (Console.with_output console ~path:(Some path) chart)
  in
  match made with
  | None -> Result.map (fun () -> Exit_code.Holds) (Result.listed table)
  | Some result ->
    let plot =
      match (o.plot, result) with
      | Some path, Ok () -> draw path
      | Some _, Error _ | None, _ -> Ok ()
    in
    let others = Guard.unwritten console [ Result.listed table; plot ] in
    let* code = conclude console seen ~count result in
    Ok (Kept_runs.finish console points (Exit_code.worst [ code; others ]))

let outputs o =
  Outputs.file ~over:o.resume "-o" (Resume.file ~output:o.output ~resume:o.resume)
  @ Outputs.file "--plot" o.plot
  @ Outputs.store o.store

let run color progress o =
  let console = Console.make ?progress ~color ~json:false () in
  let watch = Watch.start ~memory:(Check_options.words o.budget) () in
  Guard.run ~outputs:(outputs o) console (fun () -> sweep console o watch)

(* {1 The command line} *)

let axis_conv =
  let parse s =
    match String.index_opt s '=' with
    | Some i when i > 0 -> (
        let name = String.sub s 0 i in
        match Grid.values (String.sub s (i + 1) (String.length s - i - 1)) with
        | Ok values -> Ok { Grid.name; values }
        | Error text -> Error (`Msg text))
    | _ -> Error (`Msg (Printf.sprintf "`%s' is not of the form name=values" s))
  in
  Arg.conv ~docv:"NAME=VALUES" (parse, fun ppf (a : Grid.axis) -> Format.pp_print_string ppf a.name)

let grid =
  let doc =
    "The values of the parameter $(i,NAME): one, $(b,3); a list, $(b,1,2,5); a range with steps of 1, \
     $(b,1..10), or with other steps, $(b,0:2:1/8). Repeatable: each value is combined with each of the others, \
     those of the last option fastest."
  in
  Arg.(non_empty & opt_all axis_conv [] & info [ "D"; "define" ] ~docv:"NAME=VALUES" ~doc)

let checks = Chosen_checks.option ~doc:"Checks only the property $(docv). May be given several times."

let decimals =
  Options.maybe (Options.integer ~least:0 ~most:1000 "number of decimals") [ "decimals" ] ~docv:"K"
    "Writes measured numbers in CSV with $(docv) decimals, instead of exactly as texts $(b,p/q). The lower end is \
     rounded down and the upper one up, so that the number is between them; the names of the columns say so."

let form =
  Options.default (Arg.enum [ ("csv", Csv); ("jsonl", Jsonl) ]) Csv [ "format" ] ~docv:"FORMAT"
    "$(b,csv) (RFC 4180), a line for each point and check, or $(b,jsonl), a JSON object for each point."

let resume =
  Options.maybe Options.named [ "resume" ] ~docv:"FILE"
    "Continues $(docv), written with $(b,--format jsonl) by a sweep that was interrupted. All options except \
     $(b,--jobs) must be the same. The exit code is about the new points."

let plot =
  Options.maybe Options.named [ "plot" ] ~docv:"FILE"
    "Draws the sweep, as SVG: measured numbers as curves over one parameter; verdicts, and numbers over two \
     parameters, as coloured cells."

let store_option =
  Kept.option
    ~doc:
      "Stores the points in the folder $(docv), which is created if necessary, while they are computed. The same \
       command resumes, and so does one with another $(b,--jobs), or with another output of the same points \
       ($(b,--format), $(b,--plot)). See STORES."

let estimate_flag =
  Options.flag [ "estimate" ]
    "Estimates the probabilities and means of the checks from runs, as $(b,scc estimate) does at each point, and \
     explores nothing. The table has the columns $(b,estimate), $(b,from), $(b,to) and $(b,runs)."

(* The options of estimates, where they are of use. *)
let estimated ~asked (how : Estimate_options.t) (b : Budget.t) ~plot =
  let bound name given = if Option.is_some given then [ name ] else [] in
  let of_checks =
    List.concat
      [
        bound "--depth" b.depth; bound "--time" b.time; bound "--states" b.states; bound "--bits" b.bits;
        bound "--plot" plot;
      ]
  in
  match (asked, of_checks, Estimate_options.given how) with
  | true, option :: _, _ -> Error (option ^ " does not go with --estimate")
  | false, _, option :: _ -> Error (option ^ " is about estimates: it needs --estimate")
  | true, [], _ -> Ok (Some how)
  | false, _, [] -> Ok None

let twice grid =
  let rec go = function
    | [] -> None
    | (a : Grid.axis) :: rest ->
      if List.exists (fun (b : Grid.axis) -> String.equal a.name b.name) rest then Some a.name else go rest
  in
  go grid

let options =
  let make path grid checks budget jobs part form decimals output resume store plot asked how =
    let size = Grid.size grid in
    let axes = if Option.is_some plot then Picture.axes grid else Ok [] in
    let* estimated = estimated ~asked how budget ~plot in
    match (twice grid, Resume.conflict ~resume ~store ~part ~lines:(form = Jsonl), axes) with
    | Some name, _, _ -> Error (Printf.sprintf "-D %s is there twice" name)
    | None, _, _ when Z.gt size (Z.of_int Grid.most) ->
      Error (Printf.sprintf "the grid has %s points: at most %d" (Z.to_string size) Grid.most)
    | None, Some text, _ -> Error text
    | None, None, _ when Option.is_some resume && Option.is_some plot -> Error "--resume does not go with --plot"
    | None, None, _ when Option.is_some plot && Option.is_some part -> Error "--plot does not go with --part"
    | None, None, _ when Option.is_some decimals && form = Jsonl ->
      Error "--decimals is for csv: the numbers of jsonl are exact"
    | None, None, Error text -> Error ("--plot: " ^ text)
    | None, None, Ok _ ->
      Ok { path; grid; checks; budget; jobs; part; form; decimals; output; resume; store; plot; estimated }
  in
  Term.(
    term_result' ~usage:true
      (const make $ Options.model_file $ grid $ checks $ Check_options.budget $ Run_options.jobs
       $ Task_part.option ~what:"points" $ form $ decimals
       $ Options.output "Writes to $(docv) instead of standard output." $ resume $ store_option $ plot
       $ estimate_flag $ Estimate_options.term))

let command =
  let told =
    [
      (Exit_code.Holds, "if everything is decided, whatever it is.");
      ( Exit_code.Undecided,
        "if something is undecided or holds up to a bound, or the model is invalid somewhere." );
      (Exit_code.Invalid, "if the model is invalid at all points.");
      ( Exit_code.Stopped,
        "if it was interrupted, or a limit of seconds or memory left something open; the finished points are \
         written." );
    ]
  in
  let exits = Exits.man ~told ~never:[ Violated ] () in
  let info = Cmd.info "sweep" ~doc:"check a model over a grid of parameters" ~man:Manual.sweep ~exits in
  Cmd.v info Term.(const run $ Options.color $ Options.progress $ options)
