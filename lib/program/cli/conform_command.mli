(** [scc conform]: whether the semantics of a model allows a recorded trace. *)

val command : Scc_session.Exit_code.t Cmdliner.Cmd.t
