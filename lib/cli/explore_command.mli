(** [scc explore]: the explored graph of a model, written for other tools. *)

val command : Exit_code.t Cmdliner.Cmd.t
