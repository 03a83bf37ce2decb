(** Real algebraic numbers: the exact instants at which something changes along a trajectory. *)

type t = private
  | Rational of Rat.t
  | Irrational of { polynomial : Polynomial.t; low : Rat.t; high : Rat.t }
  (** The only root of a square-free primitive polynomial in the open interval (low, high). It is irrational, and
      the polynomial vanishes at neither end. *)

val of_rat : Rat.t -> t
(** [of_rat r] is the rational number [r]. *)

val zero : t
(** The number 0. *)

val roots : Polynomial.t -> low:Rat.t -> high:Rat.t option -> t list
(** [roots p ~low ~high] is the real roots of [p] in the open interval (low, high), increasing, each once; [high =
    None] is infinity. [p] is not zero (a bug otherwise). *)

val isolated : Polynomial.t -> low:Rat.t -> high:Rat.t -> t
(** [isolated p ~low ~high] is the only root of [p] in the open interval (low, high). At the ends [p] has opposite
    signs, neither of them 0. *)

val to_rat : t -> Rat.t option
(** [to_rat a] is the number as a rational; [None] if it is irrational. *)

val compare : t -> t -> int
(** The order of the real numbers, decided exactly. *)

val equal : t -> t -> bool
(** [equal a b] is true if both are the same real number, whatever polynomials and intervals represent it. *)

val compare_rat : t -> Rat.t -> int
(** [compare_rat a r] is [compare a (of_rat r)]. *)

val sign_at : Polynomial.t -> t -> int
(** [sign_at p a] is the exact sign of p(a): -1, 0 or 1. *)

val between : t -> t -> Rat.t
(** [between a b] is a rational number strictly between [a] and [b], for [a < b] (a bug otherwise). *)

val enclose : t -> width:Rat.t -> Rat.t * Rat.t
(** [enclose a ~width] is rational bounds of [a], at most [width > 0] apart: [a] twice if it is rational, and
    otherwise an open interval around it. *)

val add_rat : Rat.t -> t -> t
(** [add_rat r a] is r + a. *)

val to_decimal : ?digits:int -> t -> string
(** [to_decimal ~digits a] is the nearest decimal fraction with [digits] places after the point, 6 by default, in
    the form of {!Decimal.padded}. *)

val to_string : ?variable:string -> t -> string
(** [to_string ~variable a] is ["5/4"], or e.g. ["root of 2t^2 - 3 in (6/5, 13/10), about 1.224745"]; the variable
    is ["t"] by default. *)
