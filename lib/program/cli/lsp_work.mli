(** What the language server does in processes of its own: checks and pages. *)

val work : Scc_lsp.Commands.work
(** The work of its commands. *)
