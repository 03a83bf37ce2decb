(** [scc trace]: one run of a model, as JSON Lines or in words. *)

val command : Scc_verdicts.Exit_code.t Cmdliner.Cmd.t
(** Makes one run of a model and prints its events. *)
