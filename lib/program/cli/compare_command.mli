(** [scc compare]: equivalence of two models. *)

val command : Scc_verdicts.Exit_code.t Cmdliner.Cmd.t
(** Decides whether two models are equivalent, and shows a difference if they are not. *)
