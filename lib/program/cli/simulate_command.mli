(** [scc simulate]: many runs of a model. *)

val command : Scc_verdicts.Exit_code.t Cmdliner.Cmd.t
(** Makes many runs of a model and reports their statistics. *)
