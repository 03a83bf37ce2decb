(** [scc decompose]. *)

val command : Scc_session.Exit_code.t Cmdliner.Cmd.t
(** Cuts a solid that is not convex into convex parts. *)
