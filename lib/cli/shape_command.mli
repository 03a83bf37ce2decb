(** [scc shape]. *)

val command : Exit_code.t Cmdliner.Cmd.t
