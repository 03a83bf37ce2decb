(** [scc compare]: are two models equivalent? *)

val command : Scc_session.Exit_code.t Cmdliner.Cmd.t
