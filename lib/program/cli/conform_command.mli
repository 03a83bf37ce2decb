(** [scc conform]: a recorded trace against the semantics of a model. *)

val command : Scc_verdicts.Exit_code.t Cmdliner.Cmd.t
(** Decides whether the semantics of a model allows a recorded trace, and shows the first divergence if it does
    not. *)
