open Scc_base
open Scc_exact
open Scc_loading
open Scc_verdicts
open Scc_runs
open Scc_export
open Cmdliner

type format = Glb | X3d | Vtp | Simularium | Obj | Csv

let formats =
  [ ("glb", Glb); ("x3d", X3d); ("vtp", Vtp); ("simularium", Simularium); ("obj", Obj); ("csv", Csv) ]

type options = {
  path : string;
  given : Options.definitions;
  choices : Chosen_run.options;
  format : format;
  at : Rat.t option;
  every : Rat.t option;
  observed : string list;
  output : string option;
}

(* {1 What is asked for} *)

let instant (f : Film.t) at =
  let over = Film.duration f in
  let time = Option.value at ~default:over in
  if Rat.compare time over <= 0 then Ok time
  else
    Error
      [
        Diag.error Code.bad_value Span.command_line
          "the run is over at time %s: there is no state at %s" (Rat.to_string over) (Rat.to_string time);
      ]

let check_every (f : Film.t) = function
  | Some every when Film.too_many f ~every ->
    Error
      [
        Diag.error Code.bad_value Span.command_line ~hint:"a longer step, or an earlier end by --time"
          "the run lasts %s: it has more than %d multiples of %s"
          (Rat.to_string (Film.duration f))
          Film.most_instants (Rat.to_string every);
      ]
  | Some _ | None -> Ok ()

(* {1 Files} *)

let make_folder path =
  try Ok (if not (Sys.file_exists path) then Sys.mkdir path 0o777) with
  | Sys_error message ->
    Error
      [
        Diag.error Code.cannot_write
          (Span.of_file path)
          "cannot make this folder: %s" (Os_error.reason path message);
      ]

let alone console o write = Result.listed (Console.with_output console ~path:o.output write)

let several o files =
  match o.output with
  | None -> Bug.fail __POS__ "several files without a name"
  | Some path -> Result.listed (Whole_file.write (files path))

let write console o (f : Film.t) observables =
  let* () = check_every f o.every in
  match o.format with
  | Glb -> alone console o (Gltf.file f)
  | X3d -> alone console o (X3d.file f)
  | Csv -> (
      match f.run with
      | States course -> alone console o (Table.at course observables (Film.instants f ~every:o.every))
      | Changes _ -> Bug.fail __POS__ "a table of a run without its states")
  | Obj ->
    let* time = instant f o.at in
    alone console o (Obj.state f ~time)
  | Simularium -> several o (fun path -> Simularium.files f ~path ~every:o.every)
  | Vtp ->
    let* () = Option.fold ~none:(Ok ()) ~some:(fun path -> make_folder (Vtk.folder path)) o.output in
    several o (fun path -> Vtk.files f ~path ~times:(Film.instants f ~every:o.every))

let too_great o =
  Diag.error Code.number_too_large
    (Span.of_file o.path)
    ~hint:"`--format csv` tells exact numbers, however great"
    "the run leads to a number that is too great for the floats of this format"

(* {1 The command} *)

(* Nothing is written of a run that is not done: an interruption ends the command where it is. *)
let never () = false

(* A table asks for whole states, one after the other unless it is of given times; all else for what changes,
   where a run tells it. *)
let follow o (l : Loaded.t) policy limits =
  if o.format = Csv || not (Scc_engine.Run.inertial l.model) then
    let* course, ending = Chosen_run.follow l policy limits ~interrupted:never in
    Ok (Film.States course, ending)
  else
    let ways = ref None in
    let note (event : Replay.event) =
      match (event, !ways) with
      | Start s, _ -> ways := Some (Ways.start l.semantics s)
      | _, Some w -> Ways.step w event
      | _, None -> Bug.fail __POS__ "a run without a start"
    in
    let* ending = Replay.run l.semantics l.declared policy limits ~interrupted:never note in
    match !ways with
    | Some w -> Ok (Film.Changes w, ending)
    | None -> Bug.fail __POS__ "a run without a start"

let table console o (chosen : Chosen_run.t) (l : Loaded.t) observables =
  let lines = ref None in
  let start s = lines := Some (Table.start l.semantics observables s) in
  let leg g = Option.iter (fun t -> Table.leg t g) !lines in
  match (Chosen_run.each l chosen.policy chosen.limits ~interrupted:never ~start ~leg, !lines) with
  | Ok (rest, ending), Some t ->
    let* () = alone console o (Table.finish t ~rest) in
    Ok (Chosen_run.finish console ~is_cut:chosen.is_cut l (Ok ending))
  | Error failure, _ -> Ok (Chosen_run.finish console l (Error failure))
  | Ok _, None -> Bug.fail __POS__ "a run without a start"

let film console o (chosen : Chosen_run.t) loaded observables =
  match follow o loaded chosen.policy chosen.limits with
  | Error failure -> Ok (Chosen_run.finish console loaded (Error failure))
  | Ok (run, ending) ->
    let film = { Film.title = Filename.basename o.path; origin = chosen.loaded.origin; run } in
    let* () =
      match write console o film observables with
      | result -> result
      | exception Floats.Too_great -> Error [ too_great o ]
    in
    Ok (Chosen_run.finish console ~is_cut:chosen.is_cut loaded (Ok ending))

let export console o =
  let* chosen = Chosen_run.prepare console o.choices ~given:o.given o.path in
  if chosen.sampled <> [] then Console.note console ("scc: for " ^ Sample.to_string chosen.sampled);
  let* loaded, observables = Observed.all console chosen.loaded o.observed in
  match (o.format, o.every) with
  | Csv, None -> table console o chosen loaded observables
  | _ -> film console o chosen loaded observables

let run color o =
  let console = Console.make ~color ~json:false () in
  Memory.spare_runs ();
  Guard.run ~outputs:(Outputs.file "-o" o.output) console (fun () -> export console o)

(* {1 The command line} *)

let format =
  Options.maybe (Arg.enum formats) [ "format" ] ~docv:"FORMAT"
    "The format to write: $(b,glb) (glTF), $(b,x3d), $(b,vtp) (a series for ParaView), $(b,simularium), $(b,obj) \
     (one state) or $(b,csv) (a table of numbers). By default the ending of $(b,-o) selects it."

let output =
  Options.output
    "Writes to $(docv) instead of standard output. The series of $(b,vtp) and the meshes of $(b,simularium) go \
     to files beside it, so these formats need a name."

let at =
  Options.maybe (Options.not_negative "time") [ "at" ] ~docv:"TIME"
    "With $(b,obj): the state at the time $(docv). The default is the end of the run."

let every =
  Options.maybe (Options.positive "step") [ "every" ] ~docv:"STEP"
    "With $(b,vtp), $(b,simularium) and $(b,csv): the states at the multiples of $(docv). By default $(b,vtp) \
     has each instant with an event, $(b,csv) each state after a transition, and $(b,simularium) a hundred steps \
     of the same length."

let observed =
  Options.repeated Arg.string [ "observe" ] ~docv:"FORMULA"
    "With $(b,csv): a column for $(docv), any number or predicate of a state that a check can name. May be given \
     several times."

let of_ending output =
  match Option.map Filename.extension output with
  | Some ".pvd" -> Some Vtp
  | Some ending when String.length ending > 1 ->
    List.assoc_opt (String.sub ending 1 (String.length ending - 1)) formats
  | Some _ | None -> None

let fitting o =
  let only what given list =
    if given && not (List.mem o.format list) then
      Error (Printf.sprintf "%s does not go with this format" what)
    else Ok ()
  in
  let* () = only "--at" (Option.is_some o.at) [ Obj ] in
  let* () = only "--every" (Option.is_some o.every) [ Vtp; Simularium; Csv ] in
  let* () = only "--observe" (o.observed <> []) [ Csv ] in
  match (o.format, o.output) with
  | (Vtp | Simularium), (None | Some "-") ->
    Error "this format has several files: say by -o where they go"
  | _, _ -> Ok o

let options =
  let make path given choices format at every observed output =
    match (format, of_ending output) with
    | None, None -> Error "which format? --format says so, or the ending of -o"
    | Some format, _ | None, Some format ->
      fitting { path; given; choices; format; at; every; observed; output }
  in
  let choices = Chosen_run.options ~sampled:"A line on standard error tells the values." in
  Term.(
    term_result' ~usage:true
      (const make $ Options.model_file $ Options.definitions $ choices $ format $ at $ every $ observed $ output))

let command =
  let told =
    [
      (Exit_code.Holds, "if the run is written to its end, or to a requested limit.");
      (Undecided, "if the run ends in a dead end: it is written up to there; the error is SC0602.");
    ]
  in
  let exits = Exits.man ~told ~never:[ Violated ] () in
  Cmd.v
    (Cmd.info "export" ~doc:"write a run for other programs" ~man:Manual.export ~exits)
    Term.(const run $ Options.color $ options)
