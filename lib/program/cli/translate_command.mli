(** [scc translate]. *)

val command : Scc_session.Exit_code.t Cmdliner.Cmd.t
(** Writes a model in another notation. *)
