(** [scc check]. *)

val command : Scc_session.Exit_code.t Cmdliner.Cmd.t
