(** [scc compare]: are two models equivalent? *)

val command : Exit_code.t Cmdliner.Cmd.t
