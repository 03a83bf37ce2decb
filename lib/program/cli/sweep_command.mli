(** [scc sweep]: checks over a grid of parameters. *)

val command : Scc_verdicts.Exit_code.t Cmdliner.Cmd.t
(** Checks a model at each point of a grid of parameters. *)
