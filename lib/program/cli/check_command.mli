(** [scc check]. *)

val command : Scc_session.Exit_code.t Cmdliner.Cmd.t
(** Explores a model and verifies its properties. *)
