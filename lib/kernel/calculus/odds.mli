(** How likely something is left to chance (rule Lot). *)

open Scc_exact

type t =
  | Chance of Rat.t  (** the probability at each split instant, from 0 to 1 *)
  | Rate of { rate : Rat.t; alone : Rat.t }
  (** how often per unit of time, from 0 on; and the probability within a split step, if nothing competes with it
  *)

val equal : t -> t -> bool
val compare : t -> t -> int
val hash : t -> int

val to_string : t -> string
(** [chance 1/10] or [rate 2]. *)

val within : step:Rat.t -> Rat.t -> Rat.t
(** [within ~step r] for r >= 0 and step > 0: the probability q that an event which happens at the rate r happens
    within a step. With v = 1 - exp(-r step), which is irrational for r > 0, q is the simplest fraction with
    |q - v| < 2^-40 min(v, 1 - v): so q and 1 - q are both right to a relative error of 2^-40, and 0 < q < 1. 0 for
    r = 0. The time that it takes grows with r step, which had better be {!greatest} at most. *)

val greatest : int
(** The greatest rate times split step that models may have: 1000. *)

val shares : step:Rat.t -> t list -> Rat.t list
(** What each comes to where they compete: a chance is what it is; rates together are as likely as one rate that
    is their sum, and each has its share in that. The whole may be more than 1. *)
