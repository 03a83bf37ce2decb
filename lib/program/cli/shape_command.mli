(** [scc shape]. *)

val command : Scc_session.Exit_code.t Cmdliner.Cmd.t
(** Reports on a polyhedron. *)
