(** [scc inflate ICON -o SHAPE]: from a drawing to a solid. *)

val command : Scc_verdicts.Exit_code.t Cmdliner.Cmd.t
(** Makes a solid from a drawn silhouette. *)
