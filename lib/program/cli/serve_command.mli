(** [scc serve]. *)

open Scc_session

val command : Exit_code.t Cmdliner.Cmd.t
