(** The language server: LSP 3.17 over standard input and output (specs/editors.md). *)

(** How a session ended. *)
type ending =
  | Shut  (** by [exit] or the end of the input, after [shutdown] *)
  | Broken_off  (** without [shutdown] *)

val run : version:string -> Commands.work -> ending
(** Answers the messages of standard input until [exit] or the end of the input. Raises
    {!Scc_system.Reading.Failed}, {!Scc_system.Standard.Closed} and {!Scc_system.Standard.Failed}. *)
