open Scc_verdicts
open Cmdliner

let serve () =
  match Scc_lsp.Server.run ~version:Version.current Lsp_work.work with
  | Shut -> Exit_code.Holds
  | Broken_off -> Violated
  | exception Scc_system.Standard.Closed -> Stopped
  | exception Scc_system.Standard.Failed why -> raise (Console.output_failed "standard output" why)

(* Editors pass it to servers that have other transports as well. *)
let stdio =
  Arg.(value & flag & info [ "stdio" ] ~doc:"Changes nothing: the server has no other transport.")

let run (_ : bool) =
  let console = Console.make ~color:Never ~json:false () in
  Guard.run console (fun () -> Ok (serve ()))

let command =
  let exits =
    Exits.man () ~never:[ Undecided ]
      ~told:
        [
          (Holds, "if the client has sent $(b,shutdown), and then $(b,exit) or the end of the input.");
          (Violated, "if $(b,exit) or the end of the input came without $(b,shutdown).");
          (Invalid, "if standard input cannot be read.");
          (Stopped, "if an interruption ended the server, or the reader of its messages has ended.");
        ]
  in
  Cmd.v
    (Cmd.info "lsp" ~doc:"help to write models in an editor" ~man:Manual.lsp ~exits)
    Term.(const run $ stdio)
