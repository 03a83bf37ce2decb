(** [scc serve]. *)

open Scc_verdicts

val command : Exit_code.t Cmdliner.Cmd.t
(** Serves an editor for a model, with its documents, to a browser on this machine. *)
