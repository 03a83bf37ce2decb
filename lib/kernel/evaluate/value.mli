(** Numbers along a piece of a trajectory: rational functions of the offset, exact. *)

open Scc_ctl
open Scc_exact

type t =
  | Ratio of Polynomial.t * Polynomial.t
  (** numerator and denominator; the denominator vanishes nowhere on the piece *)
  | Undefined of string  (** why there is no number, for a person *)

val equal : t -> t -> bool
(** Whether they are told alike: as quotients of the same polynomials, or undefined for one reason. *)

val greatest_degree : int
(** Numbers whose numerator or denominator would have a greater degree are undefined: finding the roots of
    such a polynomial could take hours. *)

val of_curve : Scc_motion.Path.curve -> t
val not_followed : string

val polynomial : Polynomial.t -> t
val of_rat : Rat.t -> t
val of_int : int -> t
val add : t -> t -> t
val sub : t -> t -> t
val mul : t -> t -> t
val neg : t -> t

val div : reason:string -> Timeline.extent -> t Timeline.t -> t Timeline.t -> t Timeline.t
(** Undefined, with the reason, wherever the divisor is zero. *)

val compare :
  Scc_calculus.Law.comparison -> Timeline.extent -> t Timeline.t -> t Timeline.t -> Truth.t Timeline.t
(** Undecided wherever a side is undefined. *)

val at : t -> Algebraic.t -> string
(** The value at an offset of its piece, for a person: exact when it is rational, else a decimal
    fraction near it. *)
