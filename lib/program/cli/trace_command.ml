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
  memory : int option;
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
  let watch = Watch.start ~memory:(Check_options.words_of o.memory) () in
  Scc_base.Memory.spare_runs ();
  Guard.run ~outputs:(Outputs.file "-o" o.output) console (fun () ->
      let* chosen = Chosen_run.prepare console o.choices ~given:o.given o.path in
      let write = write_run o chosen watch in
      match Console.with_output console ~path:o.output write with
      | Ok result -> Ok (Chosen_run.finish console ~is_cut:chosen.is_cut chosen.loaded result)
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
  let make path given choices form full states memory output =
    { path; given; choices; form; full; states; memory; output }
  in
  Term.(
    const make $ Options.model_file $ Options.definitions $ choices $ form $ full $ states
    $ Check_options.memory () $ output)

let command =
  let told =
    [
      (Exit_code.Holds, "if the run is printed to its end, or to a requested limit.");
      ( Exit_code.Undecided,
        "if the run ends in a dead end: it is printed up to there, the trace is complete, and says $(b,stuck); \
         the error is SC0602." );
      (Stopped, "if it was interrupted, or met the limit of --memory: the run is printed up to there.");
    ]
  in
  let exits = Exits.man ~told ~never:[ Violated ] () in
  let info = Cmd.info "trace" ~doc:"run a model and print what happens" ~man:Manual.trace ~exits in
  Cmd.v info Term.(const run $ Options.color $ options)
