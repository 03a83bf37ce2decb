(** [scc oracle]: the service of {!Scc_oracle.Oracle} over standard input and output. *)

val command : Scc_verdicts.Exit_code.t Cmdliner.Cmd.t
(** Answers the requests of other programs until the input ends. *)
