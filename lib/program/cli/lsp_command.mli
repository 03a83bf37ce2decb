(** The command [scc lsp]. *)

val command : Scc_verdicts.Exit_code.t Cmdliner.Cmd.t
