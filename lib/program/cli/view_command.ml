open Scc_base
open Scc_exact
open Scc_verdicts
open Scc_view
open Cmdliner

type what = Page | Data | Picture of Rat.t
type options = {
  shown : Viewed.options;
  output : string option;
  what : what;
  drawing : Scc_picture.Picture.options;
}

let output_of o =
  match o.output with
  | Some path -> path
  | None ->
    let base = Filename.remove_extension (Filename.basename o.shown.path) in
    let ending = match o.what with Page -> ".html" | Data -> ".view.json" | Picture _ -> ".svg" in
    (if String.equal o.shown.path "-" then "model" else base) ^ ending

let known families model names =
  let may_be_empty name = Scc_elaborate.Repeated.has_body families name in
  match Scc_picture.Picture.unknown model (List.filter (fun n -> not (may_be_empty n)) names) with
  | None -> Ok ()
  | Some name ->
    Error
      [
        Diag.error Code.unknown_name Span.command_line "no body, part or family of bodies is called `%s`" name
          ~hint:"parts of compounds are named with their body, as in --without room.south";
      ]

(* What writes the file. *)
let content console o watch =
  let document () = Viewed.document console o.shown watch in
  match o.what with
  | Data -> Result.map Document.write (document ())
  | Page ->
    let page (d : Document.t) = Page.write ~title:(d.name ^ " – scc") (Document.write d) in
    Result.map page (document ())
  | Picture time ->
    let* families, model, state = Pictured.state console o.shown watch time in
    let* () = known families model o.drawing.without in
    Ok (fun put -> put (Scc_picture.Picture.svg model state o.drawing))

let run color progress budget o =
  let o = { o with shown = { o.shown with budget } } in
  let console = Console.make ?progress ~color ~json:false () in
  Memory.spare_runs ();
  Guard.run ~outputs:(Outputs.file "-o" (Some (output_of o))) console (fun () ->
      let watch = Check_options.watch budget in
      let* write = content console o watch in
      let interrupted = Watch.interrupted watch () in
      Watch.finish watch;
      Console.progress_done console;
      let output = output_of o in
      match Console.with_output console ~path:(Some output) write with
      | Error d -> Error [ d ]
      | Ok () ->
        if not (String.equal output "-") then Console.note console (Printf.sprintf "scc: wrote %s" output);
        if interrupted then begin
          Console.note console "scc: interrupted: what was done until then is shown";
          Ok Exit_code.Stopped
        end
        else Ok Holds)

(* The command line. *)

let output =
  Options.output "Writes to $(docv) instead of the name of the model with $(b,.html), in the present folder."

let data_alone =
  Options.flag [ "data" ]
    "Writes only the data of the page, as JSON ($(b,specs/schema/view.schema.json)), for other viewers."

let check =
  Options.maybe Arg.string [ "check" ] ~docv:"NAME" "Shows the check $(docv) alone."

let schedule =
  Options.maybe Arg.string [ "schedule" ] ~docv:"FILE"
    "Shows the run of the schedule $(docv), as $(b,scc check --witness) writes it; then nothing is checked."

let trace =
  Options.maybe Arg.string [ "trace" ] ~docv:"FILE"
    "Shows the run of a trace, as $(b,scc trace) writes it; then nothing is checked."

let followed =
  let one schedule trace =
    match (schedule, trace) with
    | Some _, Some _ -> Error "--schedule and --trace do not go together: either tells which run to show"
    | Some path, None | None, Some path -> Ok (Some path)
    | None, None -> Ok None
  in
  Term.(term_result' ~usage:true (const one $ schedule $ trace))

let plots =
  Options.repeated Arg.string [ "plot" ] ~docv:"NUMBER"
    "Plots the number $(docv) over time, written as in a check: $(b,distance2\\(p, q\\)). May be given several \
     times. Numbers in the checks are always plotted."

let graph =
  Options.default (Options.integer ~least:0 "number of states") 1000 [ "graph" ] ~docv:"N"
    "Includes alternatives to the shown runs: at most $(docv) states in all. There are fewer if each state is \
     large, or if half of $(b,--seconds) is over."

let svg =
  Options.maybe (Options.not_negative "model time") [ "svg" ] ~docv:"TIME"
    "Writes a picture of the state at the model time $(docv) instead of a page, as SVG, with exact hidden \
     surfaces. Walls that hide a body entirely are drawn as glass. The run is that of $(b,--schedule) or \
     $(b,--trace), that which shows the verdict of $(b,--check), or that of the first choices."

let names =
  Options.flag [ "names" ] "With $(b,--svg): writes the names of bodies into the picture."

let without =
  Options.repeated Arg.string [ "without" ] ~docv:"NAME"
    "With $(b,--svg): leaves out $(docv), a body, a part of one such as a wall that hides what is behind it \
     ($(b,room.south)), or a family of bodies. May be given several times."

let camera =
  let parse text =
    match Camera_link.read text with
    | Ok camera -> Ok camera
    | Error why -> Error (`Msg ("this is no link with a camera: " ^ why))
  in
  let print ppf (_ : Camera_link.t) = Format.pp_print_string ppf "LINK" in
  Options.maybe (Arg.conv ~docv:"LINK" (parse, print)) [ "camera" ] ~docv:"LINK"
    "With $(b,--svg): sees what a page of $(b,scc view) shows, in the same frame and perspective. $(docv) is the \
     link that $(i,Copy link) of the page makes, or what follows $(b,#) in it."

let what =
  let one data svg names without picture camera =
    let drawing = Picture_options.of_state picture camera ~names ~without in
    match (data, svg) with
    | true, Some _ -> Error "--data and --svg do not go together"
    | _, None when names || without <> [] || Picture_options.given picture || Option.is_some camera ->
      Error "--names, --without, --camera, --from, --up and --width tell how --svg draws"
    | _ when Option.is_some camera && Picture_options.looks picture ->
      Error "--camera does not go with --from and --up: it says from where the picture is seen"
    | true, None -> Ok (Data, drawing)
    | false, Some time -> Ok (Picture time, drawing)
    | false, None -> Ok (Page, drawing)
  in
  Term.(
    term_result' ~usage:true
      (const one $ data_alone $ svg $ names $ without $ Picture_options.term $ camera))

let options =
  let make path given output (what, drawing) check schedule graph plots =
    let budget = { Budget.depth = None; time = None; states = None; seconds = None; memory = None; bits = None } in
    let checks = Option.fold check ~none:Viewed.All ~some:(fun name -> Viewed.Only name) in
    let shown = { Viewed.path; source = None; read_file = None; given; budget; checks; schedule; graph; plots } in
    { shown; output; what; drawing }
  in
  Term.(
    const make $ Options.model_file $ Options.definitions $ output $ what $ check $ followed $ graph
    $ plots)

let command =
  let told = [ (Exit_code.Holds, "if the page was written, for any verdicts on it.") ] in
  let exits = Exits.man ~told ~never:[ Violated; Undecided ] () in
  Cmd.v
    (Cmd.info "view" ~doc:"write a page that shows the runs of a model" ~man:Manual.view ~exits)
    Term.(const run $ Options.color $ Options.progress $ Check_options.budget $ options)
