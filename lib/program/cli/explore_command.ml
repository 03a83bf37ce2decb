open Scc_verify
open Scc_equivalence
open Scc_loading
open Scc_verdicts
open Scc_zones
open Scc_graphs
open Cmdliner

type format = Aut | Dot | Json | Tra | Drn

type options = {
  path : string;
  given : Options.definitions;
  budget : Budget.t;
  output : string;
  format : format option;
  dialect : Explicit_files.dialect;
  cadp : bool;
  all_steps : bool;
  hidden : Hide.pattern list;
  instants : bool;
  positions : bool;
}

let formats = [ ("aut", Aut); ("dot", Dot); ("json", Json); ("tra", Tra); ("drn", Drn) ]
let by_extension = ("gv", Dot) :: formats

(* What was asked for: a format that is named, or else that of the file's extension. *)
let format_of o =
  let extension = Filename.extension o.output in
  let extension =
    if String.length extension > 0 then String.sub extension 1 (String.length extension - 1) else ""
  in
  let refuse fmt = Printf.ksprintf (fun s -> Error s) fmt in
  let format =
    match o.format with Some f -> Some f | None -> List.assoc_opt extension by_extension
  in
  match format with
  | None when String.equal o.output "-" -> refuse "what goes to standard output needs a --format"
  | None ->
    refuse "`%s' does not tell its format by its extension (.%s): give one with --format" o.output
      (String.concat ", ." (List.map fst by_extension))
  | Some Tra when String.equal o.output "-" ->
    refuse "the format tra makes several files, which do not go to standard output together"
  | Some f -> Ok f

(** {2 Writing} *)

let labelling ~instants (e : Exported.t) =
  Labelling.make ~instants e.space
    (Array.of_list (State_predicates.of_checks (Explored.model e.space) e.loaded.checks))

let base o = if Filename.check_suffix o.output ".tra" then Filename.chop_suffix o.output ".tra" else o.output

(* The files, each with what writes it, and what there is to say about them. *)
let files o format (e : Exported.t) =
  let base = base o in
  let hidden text = List.exists (fun p -> Hide.matches p text) o.hidden in
  let one write = [ (o.output, write) ] in
  match format with
  | Aut ->
    let graph = Compared.graph_of_space e.space in
    let graph = if o.all_steps then graph else Passing.merge graph in
    let graph = Graph.map_labels graph (fun text -> if hidden text then Graph.tau else text) in
    (one (Scc_equivalence.Aut.write ~cadp:o.cadp graph), [])
  | Dot ->
    let l = Labelling.make ~instants:true e.space (Dot.predicates e.loaded.checks) in
    (one (Dot.write e l ~positions:o.positions), [])
  | Json ->
    let l = labelling ~instants:false e in
    (one (Graph_json.write e l), [])
  | Drn ->
    let l = labelling ~instants:o.instants e in
    (one (Drn.write e (Mdp.make l)), Exported.label_notes l)
  | Tra ->
    let l = labelling ~instants:o.instants e in
    let mdp = Mdp.make l in
    let variables = State_variables.make e.space in
    let choices =
      match o.dialect with
      | Prism -> []
      | Storm -> [ (base ^ ".clab", Explicit_files.choice_labels mdp) ]
    in
    ( [
      (base ^ ".tra", Explicit_files.transitions o.dialect mdp);
      (base ^ ".lab", Explicit_files.labels o.dialect mdp);
      (base ^ ".sta", Explicit_files.states mdp variables);
      (base ^ ".names.json", Explicit_files.names e mdp variables);
    ]
      @ choices,
      Exported.label_notes l )

let write_all console o files =
  if String.equal o.output "-" then begin
    List.iter (fun (_, write) -> write (Console.print console)) files;
    Console.flush console;
    Ok ()
  end
  else Result.listed (Whole_file.write files)

(** {2 The command} *)

(* Of the processor, after an interruption: a graph is no report that somebody waits for. *)
let seconds_to_write = 0.5

let exit_code (space : Explored.t) =
  Exit_code.of_exploration ~complete:(Explored.complete space) ~faults:space.faults ~stopped_by:space.stopped_by

let tell console exported notes =
  List.iter
    (fun line -> Console.note console ("scc: " ^ line))
    (List.tl (Exported.summary exported) @ notes)

let zone_files o format e =
  match format with
  | Dot -> [ (o.output, Zone_dot.write e ~positions:o.positions) ]
  | Json -> [ (o.output, Zone_json.write e) ]
  | Aut | Tra | Drn -> Scc_base.Bug.fail __POS__ "a format of single states for zones"

let over_zones console o watch (loaded : Loaded.t) format =
  let uncertain = Verdicts.uncertain loaded in
  let options = Check_options.starting console watch o.budget in
  let* space =
    Zone_space.explore options loaded.semantics uncertain ~declared:loaded.declared
    |> Result.map_error (Ill_formed.diagnostics loaded)
  in
  Watch.finish ~grace:seconds_to_write watch;
  Console.progress_done console;
  Console.report console space.faults;
  let exported = { Zone_exported.loaded; space } in
  let* () = write_all console o (zone_files o format exported) in
  List.iter (fun line -> Console.note console ("scc: " ^ line)) (List.tl (Zone_exported.summary exported));
  let complete = Zone_space.complete space in
  Ok (Exit_code.of_exploration ~complete ~faults:space.faults ~stopped_by:space.stopped_by)

let ordinarily console o watch (loaded : Loaded.t) format =
  let* initial = Loaded.initial loaded in
  let options = Check_options.starting console watch o.budget in
  let space = Explored.explore options loaded.semantics ~initial in
  Watch.finish ~grace:seconds_to_write watch;
  Console.progress_done console;
  Input.report console loaded (space.faults @ space.dead_ends);
  let exported = { Exported.loaded; space } in
  let files, notes = files o format exported in
  let* () = write_all console o files in
  tell console exported notes;
  Ok (exit_code space)

let explore console o format =
  let watch = Check_options.watch o.budget in
  let* loaded = Input.model console ~overrides:o.given.values ~narrowed:o.given.narrowed o.path in
  let* () =
    match format with
    | Aut | Tra | Drn -> Result.map ignore (Ordinary.refuse loaded)
    | Dot | Json -> Verdicts.graph_refused loaded
  in
  Console.report console loaded.warnings;
  (if Verdicts.over_zones loaded then over_zones else ordinarily) console o watch loaded format

(* A bound of what is explored leaves the writing as long as it takes; an interruption does not. *)
let broken_off console o why =
  let kept = if String.equal o.output "-" then "the graph is not whole" else "nothing was written" in
  Guard.stopped console (Printf.sprintf "%s; %s (what --seconds or --states end is written to its end)" why kept)

let outputs o =
  match format_of o with
  | Ok Tra ->
    let one ending = Outputs.file ("a file of -o (" ^ ending ^ ")") (Some (base o ^ ending)) in
    List.concat_map one [ ".tra"; ".lab"; ".sta"; ".names.json"; ".clab" ]
  | Ok (Aut | Dot | Json | Drn) | Error _ -> Outputs.file "-o" (Some o.output)

let run color o =
  let console = Console.make ~color ~json:false () in
  Guard.run ~outputs:(outputs o) console (fun () ->
      match format_of o with
      | Error message -> Ok (Guard.usage message)
      | Ok format -> (
          match explore console o format with
          | result -> result
          | exception Scc_system.Interruption.Interrupted why -> Ok (broken_off console o why)))

(** {2 The command line} *)

let output =
  let doc =
    "Writes to $(docv), whose extension selects the format; $(b,-) is standard output. A file is written as a \
     whole or not at all."
  in
  Arg.(required & opt (some string) None & info [ "o"; "output" ] ~docv:"FILE" ~doc)

let format =
  Options.maybe (Arg.enum formats) [ "format" ] ~docv:"FORMAT"
    "The format, whatever the extension of the file: $(b,aut), $(b,dot), $(b,json), $(b,tra) or $(b,drn) (see \
     FORMATS)."

let dialect =
  let doc = "The dialect of the explicit files: $(b,prism) or $(b,storm). For the format $(b,tra)." in
  let dialects = [ ("prism", Explicit_files.Prism); ("storm", Explicit_files.Storm) ] in
  Arg.(value & opt (enum dialects) Explicit_files.Prism & info [ "dialect" ] ~docv:"TOOL" ~doc)

let cadp =
  Options.flag [ "cadp" ]
    "Writes the invisible action as $(b,i), as CADP does, instead of $(b,\"tau\"). For the format $(b,aut)."

let all_steps =
  Options.flag [ "all-steps" ]
    "Keeps consecutive passings of time apart that have nothing else possible between them: every state is in \
     the file, under its number. For the format $(b,aut)."

let instants =
  Options.flag [ "instants" ]
    "Adds states for the instants, and for the times between them, at which a predicate of some check changes \
     while time passes, so that the labels describe whole runs. For the formats $(b,tra) and $(b,drn)."

let positions =
  Options.flag [ "positions" ] "Shows the places and motions of bodies. For the format $(b,dot)."

let options =
  let make path given budget output format dialect cadp all_steps hidden instants positions =
    { path; given; budget; output; format; dialect; cadp; all_steps; hidden; instants; positions }
  in
  Term.(
    const make $ Options.model_file $ Options.definitions $ Check_options.budget $ output $ format $ dialect
    $ cadp $ all_steps $ Hide.patterns ~also:" For the format $(b,aut)." () $ instants $ positions)

let command =
  Cmd.v
    (Cmd.info "explore" ~doc:"write the state space of a model for other tools" ~man:Manual.explore
       ~exits:(Exits.man ()))
    Term.(const run $ Options.color $ options)
