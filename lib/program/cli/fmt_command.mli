(** [scc fmt]. *)

val command : Scc_verdicts.Exit_code.t Cmdliner.Cmd.t
(** Prints models in canonical layout. *)
