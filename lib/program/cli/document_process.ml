open Scc_base
open Scc_verdicts
open Scc_oracle
open Scc_view
open Scc_json
open Scc_runs

let line_of console text =
  Console.print console (text ^ "\n");
  Console.flush console

let tell console json = line_of console (Json.line json)

(* {1 Answers} *)

let quotas = { Quotas.default with models = 4096 }

let session path =
  let slices = Time_slices.create ~memory_mib:quotas.memory_mib in
  let console = Console.make ~color:Never ~json:true () in
  let surroundings =
    {
      Session.now = Unix.gettimeofday;
      bounded = (fun ~seconds f -> Time_slices.bounded slices ~seconds f);
      passes = (fun _ -> false);
      read_file = Input.mesh_reader console path;
    }
  in
  (slices, Session.create ~quotas ~surroundings ~version:Version.current ())

(* Answers lines until there are no more; [other] knows lines that are no requests. *)
let answer console (slices, session) ~more ~other lines =
  let rec loop () =
    match Lines.next lines ~wait:ignore with
    | End -> Exit_code.Holds
    | Too_long ->
      line_of console (Oracle.too_long session);
      loop ()
    | Line line ->
      (match other line with
       | Some put -> put ()
       | None ->
         let told = Time_slices.working slices (fun () -> Oracle.handle ~more session line) in
         line_of console (Option.value told ~default:""));
      loop ()
  in
  loop ()

let lines () = Lines.make ~most:quotas.line_bytes

let desk ~path =
  let console = Console.make ~color:Never ~json:false () in
  Guard.run console (fun () ->
      Sys.set_signal Sys.sigint Sys.Signal_ignore;
      Ok (answer console (session path) ~more:[] ~other:(fun _ -> None) (lines ())))

(* {1 A document} *)

let verdict =
  Json_format.(fields [ field "name" some_text (fun (r, _) -> r.Runs.name); within snd Runs.about_members ])

let verdicts (runs : Runs.t list) =
  let of_check (r : Runs.t) = Option.map (fun check -> (r, check)) r.check in
  Json_format.(write (list verdict)) (List.filter_map of_check runs)

let diagnostics console found =
  `List (List.map (Diag_json.diagnostic ~source:(Console.source console)) found)

let ready console (d : Document.t) ~interrupted =
  `Assoc
    [
      ( "ready",
        `Assoc
          [
            ("interrupted", `Bool interrupted);
            ("verdicts", verdicts d.runs);
            ("diagnostics", diagnostics console (Console.kept console));
          ] );
    ]

(* On one line: no text of the document holds an end of a line. *)
let write console document =
  let put text = Console.print console (String.map (function '\n' -> ' ' | c -> c) text) in
  Document.write document put;
  line_of console ""

(* The handle of the model of a document. *)
let load session (d : Document.t) =
  let parameters = List.map (fun (name, v) -> (name, Json.rat v)) d.loaded.origin.parameters in
  let params = [ ("text", Json.text (Source.text d.loaded.source)); ("parameters", `Assoc parameters) ] in
  let request =
    `Assoc
      [
        ("jsonrpc", `String "2.0"); ("id", `Int 0); ("method", `String "model.load"); ("params", `Assoc params);
      ]
  in
  ignore (Oracle.handle session (Json.line request))

let text_of line =
  match Yojson.Safe.from_string line with
  | `String text -> text
  | _ | (exception Yojson.Json_error _) -> Bug.fail __POS__ "the first line is no JSON string"

(* SIGINT is blocked where nobody waits for it: it neither ends the process nor is it lost. *)
let interruptible f =
  ignore (Unix.sigprocmask SIG_UNBLOCK [ Sys.sigint ]);
  let x = f () in
  ignore (Unix.sigprocmask SIG_BLOCK [ Sys.sigint ]);
  x

let make console (shown : Viewed.options) text =
  let shown = { shown with source = Some (Source.make ~name:shown.path text) } in
  let watch = Check_options.watch shown.budget in
  let document = interruptible (fun () -> Viewed.document console shown watch) in
  let interrupted = Watch.interrupted watch () in
  Watch.dismiss watch;
  Sys.set_signal Sys.sigint Sys.Signal_ignore;
  Scc_system.Garbage.compact ();
  Result.map (fun d -> (d, interrupted)) document

let document (shown : Viewed.options) =
  let errors = Console.make ~color:Never ~json:false () in
  let progress ~phase:_ line = tell errors (`Assoc [ ("progress", `String line) ]) in
  let console = Console.make ~progress ~color:Never ~json:true () in
  Guard.run errors (fun () ->
      let lines = lines () in
      match Lines.next lines ~wait:ignore with
      | End | Too_long -> Ok Exit_code.Holds
      | Line text -> (
          match make console shown (text_of text) with
          | Error found ->
            tell console (`Assoc [ ("refused", diagnostics console found) ]);
            Ok Exit_code.Invalid
          | Ok (d, interrupted) ->
            tell console (ready console d ~interrupted);
            let answers = session shown.path in
            load (snd answers) d;
            let other = function "document" -> Some (fun () -> write console d) | _ -> None in
            Ok (answer console answers ~more:(Scc_live.Live.methods d) ~other lines)))
