(** [scc shape]. *)

val command : Scc_verdicts.Exit_code.t Cmdliner.Cmd.t
(** Reports on a polyhedron. *)
