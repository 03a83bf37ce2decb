(** [scc estimate]: probabilities and means by samples. *)

val command : Scc_verdicts.Exit_code.t Cmdliner.Cmd.t
(** Estimates probabilities and means from many runs. *)
