(** [scc diff]: the first difference of two traces. *)

val command : Exit_code.t Cmdliner.Cmd.t
