(** [scc successors]: the successors of states, for other programs ([specs/successors.md]). *)

open Scc_verdicts

val command : Exit_code.t Cmdliner.Cmd.t
(** Answers states by their successors until the input ends. *)
