(** [scc view]: a page that shows the runs of a model. *)

val command : Scc_verdicts.Exit_code.t Cmdliner.Cmd.t
(** Writes a page that shows the runs of a model. *)
