(** Chances from rates: what [rate r] means at the split instants of a model (rule Lot). *)

open Scc_exact

val greatest : int
(** The greatest [rate] times split step that is taken: 1000. *)

val of_rate : step:Rat.t -> Rat.t -> Rat.t option
(** [of_rate ~step r] for r >= 0 and step > 0: the probability q that an event which happens at the rate r happens
    within a step. With v = 1 - exp(-r step), which is irrational for r > 0, q is the simplest fraction with
    |q - v| < 2^-40 min(v, 1 - v): so q and 1 - q are both right to a relative error of 2^-40, and 0 < q < 1. 0 for
    r = 0. [None] beyond {!greatest}. *)
