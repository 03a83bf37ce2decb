(** The claims of a run over zones, in words, as {!Scc_explain.Wording} has them for runs of ordinary
    models. *)

open Scc_calculus
open Scc_symbolic
open Scc_explain

val facts : Zone_established.t -> Shown_run.claim -> string list
(** The facts at the end of the run. For a run without a goal, they are the facts when it came to its last
    state. *)

val right_after : Zone_established.t -> Shown_run.claim -> Scc_exact.Rat.t option
(** The beginning of the open interval on which the goal holds, relative to the last state. [None] if the goal
    holds at an instant of its own. *)

val argument : Model.t -> Zone_established.t -> Shown_run.claim -> Witness.argument option
(** The argument for a formula with operators within operators; [None] for other formulas. *)
