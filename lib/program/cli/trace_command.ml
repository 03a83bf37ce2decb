open Scc_verdicts
open Scc_json
open Scc_runs
open Cmdliner

(* How the run is told. *)
type form = Lines | Human | Itf

type options = {
  path : string;
  given : Options.definitions;
  choices : Chosen_run.options;
  form : form;
  full : bool;
  states : Trace.states;
  output : string option;
}

let write_run o (chosen : Chosen_run.t) watch write =
  let l = chosen.loaded in
  let run emit =
    Replay.run ~attempt:(Watch.attempt watch) l.semantics l.declared chosen.policy chosen.limits
      ~interrupted:(Watch.interrupted watch) emit
  in
  match o.form with
  | Human ->
    if chosen.sampled <> [] then write (Printf.sprintf "for %s\n" (Sample.to_string chosen.sampled));
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

let run color o =
  let console = Console.make ~color ~json:false () in
  let watch = Watch.start () in
  Scc_base.Memory.spare_runs ();
  Guard.run console (fun () ->
      let* chosen = Chosen_run.prepare console o.choices ~given:o.given o.path in
      let write = write_run o chosen watch in
      match Console.with_output console ~path:o.output write with
      | Ok result -> Ok (Chosen_run.finish console chosen.loaded result)
      | Error d -> Error [ d ])

(* The command line. *)

let form =
  let human =
    "Prints the run in words instead of JSON Lines. Equal passings of time share a line, and unchanged bodies \
     are only named. See $(b,--full)."
  in
  let itf =
    "Writes the run in the Informal Trace Format of Apalache (JSON, by convention in files $(b,.itf.json)), with \
     all numbers as exact integers or pairs of them, and every state in full. Such a trace is no schedule."
  in
  Arg.(value & vflag Lines [ (Human, info [ "human" ] ~doc:human); (Itf, info [ "itf" ] ~doc:itf) ])

let states =
  let doc =
    "Which states to print: $(b,all), the one after each transition, or $(b,ends), only the first and the last \
     one (a line $(b,state) before the end). With $(b,ends) a long run of many bodies has one line for each \
     transition. Such a trace is its own schedule, too."
  in
  let kinds = [ ("all", Trace.All); ("ends", Trace.Ends) ] in
  Arg.(value & opt (enum kinds) Trace.All & info [ "states" ] ~docv:"WHICH" ~doc)

let output = Options.output "Writes to $(docv) instead of standard output."

let options =
  let full = Options.full "With $(b,--human): prints every step, every body and all digits of numbers." in
  let choices =
    Chosen_run.options
      ~sampled:"The header of the trace has the values ($(b,--human): the first line)."
  in
  let make path given choices form full states output = { path; given; choices; form; full; states; output } in
  Term.(
    const make $ Options.model_file $ Options.definitions $ choices $ form $ full $ states $ output)

let man =
  [
    `S Manpage.s_description;
    `P
      "Makes one run of a model and prints it as JSON Lines, one object a line: a header (format and semantics \
       versions, digest of the model, values of its parameters), the initial state, then the transitions. Each \
       transition has its label, the rules that made it, the model time after it and the resulting state in full \
       (see $(b,--states)). Numbers are exact, as texts $(b,\"p/q\"). The format is described by \
       $(b,specs/schema/trace.schema.json).";
    `P
      "The output is the same, byte for byte, for the same model and choices. Each transition has the number of \
       its choice, so that a trace is its own schedule: $(b,scc trace --schedule) with a trace prints the trace \
       again.";
  ]
  @ [
    `P
      "With $(b,split_step any) bonds may be released at any time. By default a run considers weak splits only \
       at the instants of other events: it splits then, or lets all the time pass up to the next such instant. A \
       schedule may let less time pass: a choice whose label is $(b,time\\(5/4\\)) stands for any time that is \
       at most the greatest, and the choice after it may be the split. The witnesses of $(b,scc check) use such \
       choices.";
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
      (Exit_code.Holds, "if the run is printed to its end, or to a requested limit.");
      ( Exit_code.Undecided,
        "if the run ends in a dead end: it is printed up to there, the trace is complete, and says $(b,stuck); \
         the error is SC0602." );
    ]
  in
  let exits = Exits.man ~told ~never:[ Violated ] () in
  let info = Cmd.info "trace" ~doc:"run a model and print what happens" ~man ~exits in
  Cmd.v info Term.(const run $ Options.color $ options)
