(** Advice to estimate by many runs what an exploration could not compute. *)

open Scc_calculus
open Scc_verify

val within_bounds : string
(** How to ask for a number of which no range is known. *)

val of_outcome :
  Model.t -> parameter:string option -> from:State.t -> Verdict.outcome -> string option
(** [of_outcome model ~parameter ~from outcome] says what {!Estimation} tells of the probability or mean, if a
    bound on states, seconds or memory, or an interruption, kept it from being known: an interval, one end, or
    nothing unless the number is kept within bounds. Runs begin in the state [from]. It is [None] for a probability
    that is compared with 0 or 1, which samples decide on one side only. Where the model has parameters with
    ranges, or is asked about for all values of [parameter] (rule Parametric), the advice is for single values. *)
