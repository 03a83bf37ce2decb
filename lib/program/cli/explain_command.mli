(** [scc explain]: which events of a run what it shows depends on. *)

val command : Scc_session.Exit_code.t Cmdliner.Cmd.t
