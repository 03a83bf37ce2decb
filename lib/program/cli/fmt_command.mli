(** [scc fmt]. *)

val command : Scc_session.Exit_code.t Cmdliner.Cmd.t
(** Prints models in canonical layout. *)
