(** [scc check]. *)

val command : Scc_verdicts.Exit_code.t Cmdliner.Cmd.t
(** Explores a model and verifies its properties. *)
