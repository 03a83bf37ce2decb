(** What a run over zones shows, in words: as {!Scc_explain.Wording} tells it of runs of ordinary models. *)

open Scc_calculus
open Scc_symbolic
open Scc_explain

val facts : Zone_established.t -> Shown_run.claim -> string list
(** What is so where the run leads; or of a run without a goal, what was so when it came to its last state. *)

val right_after : Zone_established.t -> Shown_run.claim -> Scc_exact.Rat.t option
(** Where what the run leads to is so on an open interval: when that begins, from the last state on. *)

val argument : Model.t -> Zone_established.t -> Shown_run.claim -> Witness.argument option
(** Why: of a formula with operators within operators. *)
