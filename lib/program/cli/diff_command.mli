(** [scc diff]: the first difference of two traces. *)

val command : Scc_session.Exit_code.t Cmdliner.Cmd.t
(** Finds the first difference of two traces. *)
