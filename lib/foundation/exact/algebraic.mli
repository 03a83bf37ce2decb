(** Real algebraic numbers: the exact instants at which something changes along a trajectory. *)

type t = private
  | Rational of Rat.t
  | Irrational of { polynomial : Polynomial.t; low : Rat.t; high : Rat.t }
  (** The one root in the open interval of a square-free primitive polynomial, which vanishes at neither
      end; never a rational number. *)

val of_rat : Rat.t -> t
val zero : t

val roots : Polynomial.t -> low:Rat.t -> high:Rat.t option -> t list
(** The real roots of a non-zero polynomial in the open interval (low, high), increasing, each once;
    [high = None] is infinity. *)

val isolated : Polynomial.t -> low:Rat.t -> high:Rat.t -> t
(** The root in the open interval (low, high) of a polynomial that has one only there, and has different signs, not
    zero, at the ends. *)

val to_rat : t -> Rat.t option
(** The number, when it is rational. *)

val compare : t -> t -> int
val equal : t -> t -> bool

val compare_rat : t -> Rat.t -> int
(** [compare_rat a r] is [compare a (of_rat r)]. *)

val sign_at : Polynomial.t -> t -> int
(** The exact sign of the polynomial at the number. *)

val between : t -> t -> Rat.t
(** A rational strictly between two numbers, the lesser first (a bug if they are not in this order). *)

val enclose : t -> width:Rat.t -> Rat.t * Rat.t
(** Rational bounds, at most [width > 0] apart: the number twice when it is rational, and otherwise an open
    interval around it. *)

val add_rat : Rat.t -> t -> t
(** The sum with a rational. *)

val to_decimal : ?digits:int -> t -> string
(** The nearest decimal fraction of so many places (6 by default): {!Decimal.padded}. *)

val to_string : t -> string
(** ["5/4"], or e.g. ["root of 2t^2 - 3 in (6/5, 13/10), about 1.224745"]. *)
