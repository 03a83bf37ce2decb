open Scc_base
open Scc_system
open Scc_verdicts

let document ?stopped console code =
  let json =
    Scc_runs.Diag_json.document ?stopped ~source:(Console.source console)
      ~exit:(Exit_code.to_int code) (Console.kept console)
  in
  Console.document console json

let ended ?stopped console code =
  if Console.is_json console then document ?stopped console code;
  code

let is_of_output (d : Diag.t) = String.equal (d.code :> string) (Code.cannot_write :> string)
let is_of_command_line (d : Diag.t) = Span.equal d.span Span.command_line

let code_of diagnostics =
  if List.for_all is_of_output diagnostics then Exit_code.Unwritten
  else if List.for_all is_of_command_line diagnostics then Exit_code.Usage
  else Exit_code.Invalid

let invalid console diagnostics =
  Console.report console diagnostics;
  ended console (code_of diagnostics)

let unwritten console results =
  let code = function
    | Ok () -> Exit_code.Holds
    | Error diagnostics ->
      Console.report console diagnostics;
      code_of diagnostics
  in
  Exit_code.worst (List.map code results)

let stopped console why =
  Console.note console ("scc: " ^ why);
  ended ~stopped:why console Exit_code.Stopped

let complain lines = Standard.complain (String.concat "" (List.map (fun line -> Visible.line line ^ "\n") lines))

let complain_of console d = Standard.complain (Diag.render ~source:(Console.source console) d)

let usage message =
  complain [ "scc: " ^ message ];
  Exit_code.Usage

let by_ending path ~endings ~what find go =
  match find path with
  | Some how -> go (path, how)
  | None ->
    usage
      (Printf.sprintf "`%s' does not tell a format that %s are written in, by its ending: %s" path what
         (String.concat ", " endings))

let bug what =
  complain
    [
      "scc: internal error: " ^ what;
      "This is a fault of scc, not of the model. Please report it with the model and this command line:";
      "  " ^ String.concat " " (List.map Filename.quote (Array.to_list Sys.argv));
    ];
  Exit_code.Bug

(* Half of a report has no end. *)
let broken_off console why = if Standard.withdraw () then stopped console why else begin
    complain [ "scc: " ^ why ];
    Exit_code.Stopped
  end

let rec failed console = function
  | Fun.Finally_raised e -> failed console e
  | Console.Output_closed -> Exit_code.Stopped
  | Console.Refused text -> usage text
  | Console.Output_failed d ->
    complain_of console d;
    Exit_code.Unwritten
  | Interruption.Interrupted why ->
    Console.progress_done console;
    broken_off console why
  | Reading.Failed why ->
    invalid console [ Input.cannot_read Input.standard_input why ]
  | e -> (
      match Resources.refused e with
      | Some what ->
        complain [ "scc: " ^ what ];
        Exit_code.Stopped
      | None -> bug (Printexc.to_string e))

(* What cannot be told may fail again, but for the same reason only once. *)
let rec told console e = match failed console e with code -> code | exception e -> told console e

(* Of standard output that was lost beside other outputs. A reader that has ended gives its code, and not that of
   what it did not read. *)
let with_lost console code =
  match (Console.lost console, code) with
  | None, _ | Some Console.Output_closed, Exit_code.(Usage | Bug | Unwritten) -> code
  | Some Console.Output_closed, _ -> Exit_code.Stopped
  | Some e, _ -> Exit_code.worst [ code; told console e ]

let around console command =
  let code =
    match
      match command () with
      | Ok code -> code
      | Error diagnostics -> invalid console diagnostics
    with
    | code -> (
        Console.progress_done console;
        match Console.faults console with
        | [] -> code
        | faults -> Exit_code.worst [ code; bug (String.concat "; " faults) ])
    | exception e -> told console e
  in
  with_lost console code

let run ?(outputs = []) console command =
  around console (fun () ->
      Interruption.heed ();
      Console.declare console outputs;
      command ())

let run_on_two ?outputs console first second command =
  if String.equal first "-" && String.equal second "-" then
    usage "only one of the two can be read from standard input"
  else run ?outputs console command
