open Scc_base
open Scc_exact
open Scc_loading
open Scc_verdicts
open Scc_runs
open Scc_conform
open Cmdliner

type options = {
  path : string;
  trace : string;
  given : Options.definitions;
  tolerance : Rat.t option;
  unobserved : Hide.pattern list;
  states : int;
  memory : int option;
  run : string option;
}

let parameters (trace : Recorded.t) (given : Options.definitions) =
  let clash name =
    [ Recorded.malformed Span.command_line "the trace was made with another value of `%s` than -D gives" name ]
  in
  Origin.values ~recorded:trace.parameters ~overrides:given.values ~narrowed:given.narrowed
  |> Result.map_error clash

let check_digest (trace : Recorded.t) (origin : Origin.t) =
  match trace.digest with
  | Some (d, at) when not (String.equal d origin.digest) ->
    Error
      [
        Diag.error Code.bad_trace at ~hint:"remove its `digest` to look at it all the same"
          "the trace is of another model, or of another text of this one";
      ]
  | Some _ | None -> Ok ()

(* What it tells is held against the rules as they are now, all the same. *)
let note_semantics console (trace : Recorded.t) =
  match trace.semantics with
  | Some v when not (String.equal v Scc_calculus.Parameters.version) ->
    Console.note console
      (Printf.sprintf
         "scc: the trace was recorded by version %s of the semantics, and is held against version %s" v
         Scc_calculus.Parameters.version)
  | Some _ | None -> ()

let write_run path origin choices =
  let text = Schedule.to_string (Schedule.made origin choices ~offset:None) in
  Result.listed (Whole_file.with_file path (fun put -> put text))

(* An instant of a release that nobody told, or not exactly, could be any of uncountably many. *)
let exact_enough (l : Loaded.t) ~tolerance unobserved =
  if Result.is_ok (Ordinary.on_grid l) || (Rat.sign tolerance = 0 && unobserved = []) then Ok ()
  else
    Error
      (Diag.error Code.any_time Span.none
         "bonds of this model may be released at any time (`split_step any`), so that all events and their exact \
          times have to be in the trace"
         ~hint:"leave out --tolerance and --unobserved, or give a `split_step`")

let exit_code : Verdict.answer -> Exit_code.t = function
  | Conforms _ -> Holds
  | Diverges _ -> Violated
  | Undecided { reason = Stopped _; _ } -> Stopped
  | Undecided { reason = Fault fault; _ } -> Exit_code.of_fault fault
  | Undecided { reason = Too_many_states; _ } -> Undecided

let conform console o =
  let watch = Watch.start ~memory:(Check_options.words_of o.memory) () in
  let* source = Input.text console o.trace in
  let* trace = Read.trace source in
  let* overrides, narrowed = parameters trace o.given in
  let given =
    if o.given.values <> [] || o.given.narrowed <> [] then Span.command_line
    else Span.of_file (Source.name source)
  in
  let* l = Input.model ~given console ~overrides ~narrowed o.path in
  let* () = Ordinary.at_point l in
  let* () = check_digest trace l.origin in
  Watch.has_read watch;
  Console.report console l.warnings;
  note_semantics console trace;
  let* tolerance = Verdict.tolerance l.model trace o.tolerance in
  let* () = Result.listed (exact_enough l ~tolerance o.unobserved) in
  let observed label = not (List.exists (fun p -> Hide.matches p label) o.unobserved) in
  let limits = { Trace_search.states = o.states; stop = Watch.stop watch } in
  let* answer =
    match Verdict.check l.semantics l.declared trace ~tolerance ~observed limits with
    | Ok answer -> Ok answer
    | Error (`Invalid diagnostics) -> Error diagnostics
    | Error (`Fault fault) -> Error [ Scc_semantics.Transition.diagnostic l.model fault ]
  in
  let run =
    match (answer, o.run) with
    | Conforms { choices; _ }, Some path -> write_run path l.origin choices
    | _ -> Ok ()
  in
  Watch.finish watch;
  let code = Exit_code.worst [ exit_code answer; Guard.unwritten console [ run ] ] in
  let report = { Report.file = o.path; loaded = l; trace; tolerance; answer } in
  Console.answer console
    ~text:(fun () -> Report.text report)
    ~json:(fun () ->
        Report_json.json report ~exit:(Exit_code.to_int code) ~source:(Console.source console)
          ~diagnostics:(Console.kept console));
  Ok code

let run color json o =
  let console = Console.make ~color ~json () in
  Guard.run_on_two ~outputs:(Outputs.file "--run" o.run) console o.path o.trace (fun () -> conform console o)

(* The command line. *)

let trace =
  Options.argument 1 ~docv:"TRACE" "The trace, as JSON Lines or CSV; $(b,-) reads it from standard input."

let tolerance =
  Options.maybe (Options.not_negative "tolerance") [ "tolerance" ] ~docv:"T"
    "The tolerance of times, positions, velocities and other numbers of the trace, each by itself. With 0, the \
     default, they must be equal. A trace with floats (numbers with a point or an exponent) needs a tolerance; \
     in a rigid model it is not less than the resolution, unless it is 0."

let unobserved =
  Options.repeated Hide.pattern [ "unobserved" ] ~docv:"PATTERN"
    "Events that the trace may omit: a kind ($(b,bounce), $(b,bind), $(b,weak), $(b,strong)), or the text of a \
     label, in which $(b,*) stands for any characters: $(b,'bounce(p, *\\)'). Repeatable. The trace must have \
     every other event."

let states =
  let doc =
    "Explores at most $(docv) states for each line of the trace. If that is not enough, the trace is undecided, \
     unless it conforms anyway."
  in
  let count = Options.integer ~least:1 "number of states" in
  Arg.(value & opt count Trace_search.default_states & info [ "states" ] ~docv:"N" ~doc)

let run_file =
  Options.maybe Options.named [ "run" ] ~docv:"FILE"
    "Writes a run that agrees with the trace to $(docv), as a schedule for $(b,scc trace --schedule)."

let options =
  let make path trace given tolerance unobserved states memory run =
    { path; trace; given; tolerance; unobserved; states; memory; run }
  in
  Term.(
    const make $ Options.model_file $ trace $ Options.definitions $ tolerance $ unobserved $ states
    $ Check_options.memory () $ run_file)

let exits =
  Exits.man ()
    ~told:
      [
        (Holds, "if the trace is a run of the model, within the tolerance.");
        (Violated, "if it is not.");
        (Undecided, "if that is not known: a limit was reached.");
        (Invalid, "if the model or the trace is invalid.");
        (Stopped, "if it is not known since it was interrupted, or met the limit of --memory.");
      ]

let command =
  Cmd.v
    (Cmd.info "conform" ~doc:"decide whether a recorded trace is a run of a model, and where not"
       ~man:Manual.conform ~exits)
    Term.(const run $ Options.color $ Options.json $ options)
