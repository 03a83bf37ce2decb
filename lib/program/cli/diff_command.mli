(** [scc diff]: the first difference of two traces. *)

val command : Scc_verdicts.Exit_code.t Cmdliner.Cmd.t
(** Finds the first difference of two traces. *)
