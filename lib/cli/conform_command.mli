(** [scc conform]: whether the semantics of a model allows a recorded trace. *)

val command : Exit_code.t Cmdliner.Cmd.t
