(** [scc decompose]. *)

val command : Scc_verdicts.Exit_code.t Cmdliner.Cmd.t
(** Cuts a solid that is not convex into convex parts. *)
