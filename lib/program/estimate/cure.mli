(** Advice to estimate by many runs what an exploration could not compute. *)

open Scc_calculus
open Scc_verify

val of_outcome : Model.t -> Verdict.outcome -> string option
(** [of_outcome model outcome] is the question for [scc estimate], in words, if {!Estimation} has intervals for the
    probability or mean, and a bound on states, seconds or memory, or an interruption, kept it from being known. It
    is [None] for a probability that is compared with 0 or 1, which samples decide on one side only, and over
    zones. *)
