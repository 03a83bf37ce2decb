(** [scc sweep]: checks over a grid of parameters. *)

val command : Scc_session.Exit_code.t Cmdliner.Cmd.t
