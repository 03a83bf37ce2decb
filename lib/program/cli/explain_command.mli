(** [scc explain]: the events of a run on which its result depends. *)

val command : Scc_verdicts.Exit_code.t Cmdliner.Cmd.t
(** Explains why a run leads where it does. *)
