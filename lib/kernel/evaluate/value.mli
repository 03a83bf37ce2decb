(** Numbers along a piece of a trajectory: rational functions of the offset, exact. *)

open Scc_ctl
open Scc_exact

type t =
  | Ratio of Polynomial.t * Polynomial.t
  (** numerator and denominator; the denominator vanishes nowhere on the piece *)
  | Undefined of string  (** why there is no number, for messages *)

val equal : t -> t -> bool
(** [equal a b] is true if [a] and [b] are represented alike: as quotients of the same polynomials, or as
    undefined for the same reason. *)

val of_curve : Scc_motion.Path.curve -> t
(** The number that a curve has; undefined, for the reason {!not_followed}, if the curve is not followed. *)

val not_followed : string
(** The reason for numbers that change from turn to turn of a body that spins for ever. *)

val polynomial : Polynomial.t -> t
(** The polynomial as a number, with denominator 1. *)

val of_rat : Rat.t -> t
(** The constant number. *)

val of_int : int -> t
(** The constant number. *)

val add : t -> t -> t
(** The sum; undefined if a side is undefined, or if a degree would exceed 200: finding the roots of such a
    polynomial could take hours. *)

val sub : t -> t -> t
(** The difference, the first less the second; undefined as in {!add}. *)

val mul : t -> t -> t
(** The product; undefined as in {!add}. *)

val neg : t -> t
(** The negation; undefined if its argument is undefined. *)

val div : reason:string -> Timeline.extent -> t Timeline.t -> t Timeline.t -> t Timeline.t
(** The quotient of two numbers along this extent; undefined, with the reason, wherever the divisor is zero. *)

val compare :
  Scc_calculus.Law.comparison -> Timeline.extent -> t Timeline.t -> t Timeline.t -> Truth.t Timeline.t
(** [compare c extent a b] is true where [a] stands in the relation [c] to [b] along [extent]. It is undecided
    wherever a side is undefined. *)

val at : t -> Algebraic.t -> string
(** The value at an offset of its piece, as text for messages. At a rational offset it is exact. At an irrational
    one it is exact if it is a simple rational number; else it is a decimal fraction near the value, behind
    [about]. An undefined value gives its reason. *)
