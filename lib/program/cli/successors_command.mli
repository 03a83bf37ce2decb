(** [scc successors]: the states that follow states, for programs ([specs/successors.md]). *)

open Scc_session

val command : Exit_code.t Cmdliner.Cmd.t
