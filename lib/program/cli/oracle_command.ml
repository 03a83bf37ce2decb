open Cmdliner
open Scc_verdicts
open Scc_oracle

(* {1 The service} *)

let serve (quotas : Quotas.t) =
  let slices = Time_slices.create ~memory_mib:quotas.memory_mib in
  let surroundings =
    {
      Session.now = Unix.gettimeofday;
      bounded = (fun ~seconds f -> Time_slices.bounded slices ~seconds f);
      passes = (function Scc_system.Interruption.Interrupted _ -> true | _ -> false);
      read_file = Models.no_files;
    }
  in
  let session = Session.create ~quotas ~surroundings ~version:Version.current () in
  Conversation.hold (fun c ->
      let lines = Lines.make ~most:quotas.line_bytes in
      let wait () = Conversation.send c in
      let rec loop () =
        match Lines.next lines ~wait with
        | End -> ()
        | Too_long ->
          Conversation.say c (Oracle.too_long session);
          loop ()
        | Line line ->
          Option.iter (Conversation.say c) (Time_slices.working slices (fun () -> Oracle.handle session line));
          loop ()
      in
      loop ();
      Exit_code.Holds)

let run line_bytes seconds memory_mib =
  let console = Console.make ~color:Never ~json:false () in
  Guard.run console (fun () -> Ok (serve { Quotas.default with line_bytes; seconds; memory_mib }))

(* {1 The command line} *)

let option name docv ~most default doc =
  let doc = Printf.sprintf "%s The default is %d." doc default in
  let number = Options.integer ~least:1 ~most (Printf.sprintf "number from 1 to %d" most) in
  Arg.(value & opt number default & info [ name ] ~docv ~doc)

let line_bytes =
  option "line-bytes" "N" ~most:(1 lsl 30) Quotas.default.line_bytes
    "Skips lines of more than $(docv) bytes, and answers them by an error."

let seconds =
  option "seconds" "S" ~most:1_000_000 Quotas.default.seconds "Gives a request up after $(docv) seconds."

let memory =
  option "memory" "MIB" ~most:1_000_000 Quotas.default.memory_mib
    "Gives a request up if with it the program takes more than $(docv) MiB."

let command =
  let exits =
    Exits.man () ~never:[ Violated; Undecided ]
      ~told:
        [
          (Holds, "at the end of the input.");
          (Invalid, "if standard input cannot be read.");
          (Stopped, "if an interruption ended the service, or the reader of its answers has ended.");
        ]
  in
  Cmd.v
    (Cmd.info "oracle" ~doc:"answer other programs' questions" ~man:Manual.oracle ~exits)
    Term.(const run $ line_bytes $ seconds $ memory)
