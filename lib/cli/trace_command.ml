open Scc_exact
open Scc_session
open Scc_exchange
open Cmdliner

type choose = First | Random of int64

(* How the run is told. *)
type form = Lines | Human | Itf

type options = {
  path : string;
  given : Options.definitions;
  schedule : string option;
  choose : choose;
  start : Sample.how option;
  steps : int option;
  time : Rat.t option;
  form : form;
  full : bool;
  states : Trace.states;
  output : string option;
}

let ( let* ) = Result.bind

let prepare console o =
  match o.schedule with
  | None ->
    let* model = Input.model console ~overrides:o.given.values ~narrowed:o.given.narrowed o.path in
    Ok (model, None)
  | Some path ->
    let* schedule = Scheduled.read console path in
    let* model = Scheduled.model console schedule ~given:o.given o.path in
    Ok (model, Some schedule)

(* The ordinary model of one start: the values of -D and of the schedule, and for what they leave open those that
   are sampled. *)
let at_start o (l : Loaded.t) =
  match o.start with
  | None ->
    let* () = Ordinary.at_point ~otherwise:"`--start simple` chooses them" l in
    Ok (l, [])
  | Some how -> (
      match Sample.values how l.model.ranges with
      | [] -> Ok (l, [])
      | values ->
        let* l = Loaded.at l values in
        Ok (l, values))

let policy o = function
  | Some s -> Replay.Scheduled s
  | None -> ( match o.choose with First -> Replay.First | Random seed -> Replay.Random seed)

(* A schedule is followed to its end unless a limit is asked for. *)
let limits o schedule : Replay.limits =
  let steps =
    match (o.steps, schedule, o.time) with
    | Some n, _, _ -> Some n
    | None, None, None -> Some Replay.default_steps
    | None, _, _ -> None
  in
  { steps; time = o.time; instant = Replay.default_instant }

let write_run o (l : Loaded.t) sampled policy limits ~interrupted write =
  let run emit = Replay.run l.semantics l.declared policy limits ~interrupted emit in
  match o.form with
  | Human ->
    if sampled <> [] then write (Printf.sprintf "for %s\n" (Sample.to_string sampled));
    run (Human_trace.teller l.model ~full:o.full o.states write)
  | Lines ->
    let line json = write (Json.line json ^ "\n") in
    line (Trace.header l.origin);
    run (fun event -> List.iter line (Trace.event l.model o.states event))
  | Itf ->
    let itf = Itf.start l.model l.origin write in
    let result = run (Itf.event itf) in
    Itf.close itf;
    result

let finish console (l : Loaded.t) (result : (Replay.ending, Replay.failure) result) =
  let report d = Console.report console [ d ] in
  match result with
  | Ok Zeno ->
    Console.note console
      (Printf.sprintf "scc: stopped after %d transitions without time passing (Zeno behaviour)"
         Replay.default_instant);
    Exit_code.Stopped
  | Ok (Open | Quiescent) -> Exit_code.Holds
  | Error Interrupted ->
    Console.note console "scc: interrupted";
    Exit_code.Stopped
  | Error (Refused d) ->
    report d;
    Exit_code.Invalid
  | Ok (Stuck f) | Error (Fault f) ->
    report (Replay.diagnostic l.model f);
    Exit_code.of_fault f.fault

let run color o =
  let console = Console.make ~color ~json:false in
  let interrupted = Watch.interrupted (Watch.start ()) in
  Guard.run console (fun () ->
      let* model, schedule = prepare console o in
      let* model, sampled = at_start o model in
      Console.report console model.warnings;
      let write = write_run o model sampled (policy o schedule) (limits o schedule) ~interrupted in
      match Console.with_output console ~path:o.output write with
      | Ok result -> Ok (finish console model result)
      | Error d -> Error [ d ])

(* The command line. *)

let schedule =
  let doc =
    "Makes the choices of $(docv): a schedule, as $(b,scc check --witness) writes it, or a trace, whose \
     schedule is taken. It is followed to its end. A choice that is not possible where it is made is refused."
  in
  Arg.(value & opt (some string) None & info [ "schedule" ] ~docv:"FILE" ~doc)

(* A word, or a seed; [seed] is that of a value which is not the word. *)
let seeded ~docv word ~plain ~random ~seed =
  let parse s =
    let n = String.length s in
    if String.equal s word then Ok plain
    else if n > 7 && String.equal (String.sub s 0 7) "random:" then
      match Int64.of_string_opt (String.sub s 7 (n - 7)) with
      | Some seed -> Ok (random seed)
      | None -> Error (`Msg "the seed is no integer of 64 bits")
    else Error (`Msg (Printf.sprintf "`%s' is neither `%s' nor `random:SEED'" s word))
  in
  let print ppf x =
    match seed x with
    | None -> Format.pp_print_string ppf word
    | Some seed -> Format.fprintf ppf "random:%Ld" seed
  in
  Arg.conv ~docv (parse, print)

let choose_conv : choose Arg.conv =
  let random seed = Random seed and seed = function First -> None | Random seed -> Some seed in
  seeded ~docv:"POLICY" "first" ~plain:First ~random ~seed

let start_conv : Sample.how Arg.conv =
  let random seed = Sample.Random seed and seed = function Sample.Simple -> None | Random seed -> Some seed in
  seeded ~docv:"START" "simple" ~plain:Sample.Simple ~random ~seed

let choose =
  let doc =
    "How to choose between transitions: $(b,first), the first one, or $(b,random:SEED), each equally \
     likely, by the generator SplitMix64 from the integer $(b,SEED): the same on every machine."
  in
  Arg.(value & opt choose_conv First & info [ "choose" ] ~docv:"POLICY" ~doc)

let start =
  let doc =
    "Which start to run from where parameters have ranges: $(b,simple), simple numbers within the ranges, or \
     $(b,random:SEED), by the generator SplitMix64 from the integer $(b,SEED) for each one of the 1023 values \
     that divide its range into 1024 equal parts. Values that $(b,-D) or a schedule gives are kept, and a range \
     that $(b,-D) narrows is the one that is sampled. The header of the trace tells the values ($(b,--human): the \
     first line)."
  in
  Arg.(value & opt (some start_conv) None & info [ "start" ] ~docv:"START" ~doc)

let steps =
  let doc =
    Printf.sprintf
      "Ends the run after $(docv) transitions. The default is %d when neither a schedule nor $(b,--time) \
       ends it." Replay.default_steps
  in
  Arg.(value & opt (some Options.transitions) None & info [ "steps" ] ~docv:"N" ~doc)

let time =
  let doc = "Ends the run at the model time $(docv), between events if need be." in
  Arg.(value & opt (some (Options.not_negative "model time")) None & info [ "time" ] ~docv:"T" ~doc)

let form =
  let human =
    "Tells the run in words instead of JSON Lines: passings of the same time are told together, and bodies that \
     are as before are named only. See $(b,--full)."
  in
  let itf =
    "Writes the run in the Informal Trace Format of Apalache (JSON, by custom in files $(b,.itf.json)), with all \
     numbers as exact integers or pairs of them, and every state in full. Such a trace is no schedule."
  in
  Arg.(value & vflag Lines [ (Human, info [ "human" ] ~doc:human); (Itf, info [ "itf" ] ~doc:itf) ])

let states =
  let doc =
    "Which states to print: $(b,all), the one after each transition, or $(b,ends), only the first and the last \
     one (a line $(b,state) before the end): a long run of many bodies is then told in a line for each \
     transition. Such a trace is its own schedule, too."
  in
  let kinds = [ ("all", Trace.All); ("ends", Trace.Ends) ] in
  Arg.(value & opt (enum kinds) Trace.All & info [ "states" ] ~docv:"WHICH" ~doc)

let output =
  let doc = "Writes to $(docv) instead of standard output." in
  Arg.(value & opt (some string) None & info [ "o"; "output" ] ~docv:"FILE" ~doc)

let options =
  let full = Options.full "With $(b,--human): tells every step, every body and all digits of numbers." in
  let make path given schedule choose start steps time form full states output =
    { path; given; schedule; choose; start; steps; time; form; full; states; output }
  in
  Term.(
    const make $ Options.model_file $ Options.definitions $ schedule $ choose $ start $ steps $ time $ form
    $ full $ states $ output)

let man =
  [
    `S Manpage.s_description;
    `P
      "Runs one behaviour of a model and prints it as JSON Lines, one object a line: a header (format and \
       semantics versions, digest of the model, values of its parameters), the initial state, then each \
       transition with its label, the rules that made it, the model time after it and the resulting state \
       in full (see $(b,--states)). Numbers are exact, as texts $(b,\"p/q\"). The format is described by \
       $(b,specs/schema/trace.schema.json).";
    `P
      "The output is the same, byte for byte, for the same model and choices. Each transition tells which \
       choice it was, so that a trace is its own schedule: $(b,scc trace --schedule) with a trace prints \
       the trace again.";
  ]
  @ [
    `P
      "Where bonds may be released at any time ($(b,split_step any)), a run that is not told otherwise looks at \
       weak splits at the instants at which something else happens: then it splits, or lets all the time pass up \
       to the next such instant. A schedule may let less pass: a choice whose label is $(b,time\\(5/4\\)) stands \
       for any time that is at most the greatest, and the choice after it may be the split. The witnesses of \
       $(b,scc check) do so.";
  ]
  @ Options.diagnostics_man
  @ [
    `S Manpage.s_examples;
    `Pre "  scc trace model.sc --choose random:7 -o run.jsonl";
    `Pre "  scc trace model.sc --schedule run.jsonl | cmp - run.jsonl";
    `Pre "  scc trace model.sc --human --time 5";
    `Pre "  scc trace model.sc --human --full";
    `Pre "  scc trace ranges.sc -D y=1 --start random:7 --choose random:7";
    `Pre "  scc trace large.sc --time 100 --states=ends";
    `Pre "  scc trace model.sc --schedule runs/meet.json --itf -o meet.itf.json";
  ]

let command =
  let told =
    [
      (Exit_code.Holds, "if the run is told to its end, or to a limit that was asked for.");
      ( Exit_code.Undecided,
        "if the run ends in a dead end: it is told up to there, the trace is complete, and says $(b,stuck); the \
         error is SC0602." );
    ]
  in
  let exits = Exits.man ~told ~never:[ Violated ] () in
  let info = Cmd.info "trace" ~doc:"run a model and print what happens" ~man ~exits in
  Cmd.v info Term.(const run $ Options.color $ options)
