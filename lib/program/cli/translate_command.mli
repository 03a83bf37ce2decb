(** [scc translate]. *)

val command : Scc_verdicts.Exit_code.t Cmdliner.Cmd.t
(** Writes a model in another notation. *)
