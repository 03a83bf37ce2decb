open Scc_session
open Cmdliner

let man =
  [
    `S Manpage.s_description;
    `P
      "$(mname) executes models of the Shape Calculus: three-dimensional shapes that move, collide, bind, \
       split and react in space and time. All numbers are exact rationals.";
    `P "Every command has a manual: $(mname) $(i,COMMAND) $(b,--help).";
  ]

let commands =
  [
    Check_command.command;
    Trace_command.command; Simulate_command.command; Estimate_command.command; Sweep_command.command;
    View_command.command;
    Serve_command.command;
    Export_command.command;
    Explore_command.command;
    Explain_command.command;
    Compare_command.command;
    Conform_command.command;
    Diff_command.command;
    Shape_command.command;
    Inflate_command.command;
    Decompose_command.command;
    Oracle_command.command;
    Successors_command.command;
    Fmt_command.command;
    Translate_command.command;
  ]

(* A manual that nobody reads to its end, or that cannot be written: what is left of it is not tried again at the
   exit, where it would be an exception. What went wrong is told when standard output is flushed. *)
let drop_manual () =
  let nothing _ = () in
  Format.set_formatter_out_functions
    {
      out_string = (fun _ _ _ -> ());
      out_flush = nothing;
      out_newline = nothing;
      out_spaces = nothing;
      out_indent = nothing;
    }

let main () =
  Scc_base.Memory.spare_tables ();
  let info =
    Cmd.info "scc" ~version:Version.told ~doc:"interpreter and model checker for the Shape Calculus" ~man
      ~exits:(Exits.man ())
  in
  (* Writing to a closed pipe is an error to be handled, and not the end. *)
  if not Sys.win32 then Sys.set_signal Sys.sigpipe Sys.Signal_ignore;
  let code =
    match Cmd.eval_value ~catch:false (Cmd.group info commands) with
    | Ok (`Ok code) -> code
    | Ok (`Version | `Help) -> Holds
    | Error (`Parse | `Term) -> Usage
    | Error `Exn -> Bug
    | exception Sys_error _ -> Holds
  in
  (* The manual may still wait in the buffer. *)
  let console = Console.make ~color:Never ~json:false () in
  let flushed = Guard.run console (fun () -> Console.flush console; Ok Holds) in
  drop_manual ();
  Exit_code.to_int (Exit_code.worst [ code; flushed ])
