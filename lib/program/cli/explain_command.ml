open Scc_base
open Scc_property
open Scc_explain
open Scc_loading
open Scc_verdicts
open Scc_runs
open Scc_reports
open Cmdliner

type options = {
  witness : string;
  model : string option;
  check : string option;
  given : Options.definitions;
  full : bool;
}

let model_path o (s : Schedule.t) =
  match (o.model, s.model) with
  | Some path, _ | None, Some path -> Ok path
  | None, None ->
    Error
      [
        Diag.error Code.bad_schedule s.offset_at "this does not tell for which model it was made"
          ~hint:"name the model: `scc explain WITNESS MODEL`";
      ]

let find_check name (checks : Property.check list) ~code ~at =
  match List.find_opt (fun (c : Property.check) -> String.equal c.name name) checks with
  | Some c -> Ok (Some c)
  | None -> Error [ Input.no_check code at name checks ]

(* The property that the run is to be explained for, if any. *)
let check_of o (s : Schedule.t) checks =
  match (o.check, s.check) with
  | Some name, _ -> find_check name checks ~code:Code.unknown_name ~at:Span.command_line
  | None, Some name -> find_check name checks ~code:Code.bad_schedule ~at:s.offset_at
  | None, None -> Ok None

(* {1 The run} *)

(* A run that meets what a search looks for is decisive up to there, however it goes on; all else may rest on the
   end of the run. *)
let over check (ending : Replay.ending) =
  let searched (c : Property.check) = Plan.is_search (Plan.of_formula c.formula) in
  match ending with
  | Stuck { fault = Persistent_contact firsts; _ } when not (Option.fold ~none:false ~some:searched check) ->
    Some firsts
  | Open | Quiescent | Stuck _ | Zeno | Broken_off -> None

(* The run, and how it stands where the schedule leaves it. *)
let follow (l : Loaded.t) schedule check =
  let limits = { Replay.steps = None; time = None; instant = Replay.default_instant } in
  match Chosen_run.follow l (Scheduled schedule) limits ~interrupted:(fun () -> false) with
  | Ok (course, ending) -> Ok ({ Causes.declared = l.declared; course; over = over check ending }, ending)
  | Error (Interrupted _) -> Bug.fail __POS__ "a run that nobody interrupts"
  | Error (Refused d) -> Error [ d ]
  | Error (Fault f) -> Error [ Replay.diagnostic l.model f ]

let explanation run (check : Property.check option) =
  let story = Causes.tell run in
  let basis, props =
    match check with
    | Some c -> (Causes.of_formula story c.formula, Formula.predicates c.formula)
    | None -> (Causes.of_last_event story, [])
  in
  Omission.explain story (Causes.union [ basis; Causes.of_dead_end story ]) props

let print console ~full (model : Loaded.t) check ending explanation =
  Console.answer console
    ~text:(fun () ->
        let settings =
          match model.origin.settings with
          | [] -> ""
          | list -> Scc_calculus.Parameters.line list ^ "\n\n"
        in
        settings ^ Explain_text.lines console ~full check ending explanation)
    ~json:(fun () ->
        Explain_json.document ~source:(Console.source console)
          {
            origin = model.origin;
            check;
            ending;
            explanation;
            diagnostics = Console.kept console;
            exit = Exit_code.to_int Holds;
          })

let explain console o =
  let* schedule = Scheduled.read console o.witness in
  let* path = model_path o schedule in
  let* model = Scheduled.model console schedule ~given:o.given path in
  let* () = Ordinary.at_point model in
  Console.report console model.warnings;
  let* check = check_of o schedule model.checks in
  let* run, ending = follow model schedule check in
  (match ending with
   | Stuck s -> Console.report console [ Scc_verify.Bounds.dead_end (Replay.diagnostic model.model s) ]
   | Open | Quiescent | Zeno | Broken_off -> ());
  print console ~full:o.full model check ending (explanation run check);
  Ok ()

let run color json o =
  let console = Console.make ~color ~json () in
  Guard.run console (fun () -> Result.map (fun () -> Exit_code.Holds) (explain console o))

let witness =
  Options.argument 0 ~docv:"WITNESS"
    "The run: a schedule, as $(b,scc check --witness) writes it, or a trace, whose schedule is used."

let model =
  let doc = "The model. A schedule of $(b,scc check) names its model, by the path given then." in
  Arg.(value & pos 1 (some string) None & info [] ~docv:"MODEL" ~doc)

let check =
  Options.maybe Arg.string [ "check" ] ~docv:"NAME"
    "Explains the facts in the check $(docv) of the model. By default it is the check for which the schedule is \
     a witness; without one, the last event of the run is explained."

let options =
  let full = Options.full "Prints every step of the run, and all digits of numbers." in
  let make witness model check given full = { witness; model; check; given; full } in
  Term.(const make $ witness $ model $ check $ Options.definitions $ full)

let command =
  let exits =
    Exits.man () ~never:[ Violated; Undecided ]
      ~told:[ (Holds, "if the run is explained, also one that ends in a dead end.") ]
  in
  let info = Cmd.info "explain" ~doc:"tell why a run leads where it does" ~man:Manual.explain ~exits in
  Cmd.v info Term.(const run $ Options.color $ Options.json $ options)
