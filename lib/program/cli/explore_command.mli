(** [scc explore]: the explored graph of a model, written for other tools. *)

val command : Scc_verdicts.Exit_code.t Cmdliner.Cmd.t
(** Writes the state space of a model for other tools. *)
