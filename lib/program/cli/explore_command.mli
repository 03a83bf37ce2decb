(** [scc explore]: the explored graph of a model, written for other tools. *)

val command : Scc_session.Exit_code.t Cmdliner.Cmd.t
