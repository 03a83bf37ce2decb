open Scc_exact
open Scc_verdicts
open Scc_conform
open Cmdliner

type options = { first : string; second : string; tolerance : Rat.t option }

let read console path =
  let* source = Input.text console path in
  Read.trace source

let tolerance asked (a : Recorded.t) (b : Recorded.t) =
  let refuse at fmt = Printf.ksprintf (fun s -> Error [ Recorded.malformed at "%s" s ]) fmt in
  match (asked, a.inexact, b.inexact) with
  | Some t, _, _ -> Ok t
  | None, Some at, _ | None, None, Some at ->
    refuse at "the trace has floats: --tolerance tells how far off they may be (0: not at all)"
  | None, None, None -> Ok Rat.zero

(* Where they differ, it may be for that. *)
let note_semantics console (a : Recorded.t) (b : Recorded.t) =
  match (a.semantics, b.semantics) with
  | Some v, Some w when not (String.equal v w) ->
    Console.note console
      (Printf.sprintf "scc: the traces were recorded by versions %s and %s of the semantics" v w)
  | _ -> ()

let diff console o =
  let* a = read console o.first in
  let* b = read console o.second in
  let* tolerance = tolerance o.tolerance a b in
  note_semantics console a b;
  let found = Difference.find a b ~tolerance in
  let code : Exit_code.t = if Option.is_none found then Holds else Violated in
  Console.answer console
    ~text:(fun () -> Difference_report.text a b found)
    ~json:(fun () -> Difference_json.json a b ~tolerance ~exit:(Exit_code.to_int code) found);
  Ok code

let run color json o =
  let console = Console.make ~color ~json () in
  Guard.run_on_two console o.first o.second (fun () -> diff console o)

(* The command line. *)

let trace index docv =
  let doc = Printf.sprintf "The %s trace, as JSON Lines or CSV." (String.lowercase_ascii docv) in
  Arg.(required & pos index (some string) None & info [] ~docv ~doc)

let tolerance_option =
  Options.maybe (Options.not_negative "tolerance") [ "tolerance" ] ~docv:"T"
    "The tolerance of the numbers of the two traces, each by itself. With 0, the default, they must be equal. A \
     trace with floats needs a tolerance."

let options =
  let make first second tolerance = { first; second; tolerance } in
  Term.(const make $ trace 0 "FIRST" $ trace 1 "SECOND" $ tolerance_option)

let exits =
  Exits.man () ~never:[ Undecided ]
    ~told:
      [
        (Holds, "if the two are the same, as far as both tell.");
        (Violated, "if they differ.");
        (Invalid, "if a trace is invalid.");
        (Stopped, "if an output could not be written.");
      ]

let command =
  Cmd.v
    (Cmd.info "diff" ~doc:"tell the first difference of two traces" ~man:Manual.diff ~exits)
    Term.(const run $ Options.color $ Options.json $ options)
