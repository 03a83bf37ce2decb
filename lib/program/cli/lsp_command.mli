(** The command [scc lsp]. *)

val command : Scc_verdicts.Exit_code.t Cmdliner.Cmd.t
(** The command, its options and its manual. *)
