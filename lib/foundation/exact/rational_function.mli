(** Rational functions in one variable over the rationals: quotients of two polynomials, in lowest terms. In scc
    the variable is a parameter of which probabilities are functions. *)

type t
(** A quotient of two polynomials with integer coefficients, which have no common factor, number or polynomial. The
    leading coefficient of the denominator is positive. *)

val make : Polynomial.t -> Polynomial.t -> t
(** [make n d] is n/d. [d] is not zero (a bug otherwise). *)

val coprime : Polynomial.t -> Polynomial.t -> t
(** [coprime n d] is [make n d] for polynomials that are known to have no common root, real or complex. *)

val zero : t
(** The constant 0. *)

val one : t
(** The constant 1. *)

val variable : t
(** The variable itself. *)

val constant : Rat.t -> t
(** [constant c] is the constant [c]. *)

val numerator : t -> Polynomial.t
(** [numerator f] is the numerator in lowest terms. *)

val denominator : t -> Polynomial.t
(** [denominator f] is the denominator in lowest terms: not zero, and 1 only if all coefficients of the numerator
    are integers. *)

val to_constant : t -> Rat.t option
(** [to_constant f] is the value of a constant function; [None] for other functions. *)

val add : t -> t -> t
(** [add f g] is f + g. *)

val sub : t -> t -> t
(** [sub f g] is f - g. *)

val neg : t -> t
(** [neg f] is -f. *)

val mul : t -> t -> t
(** [mul f g] is f g. *)

val div : t -> t -> t
(** [div f g] is f/g. [g] is not zero (a bug otherwise). *)

val eval : t -> Rat.t -> Rat.t option
(** [eval f x] is the value f(x); [None] if [f] has a pole at [x]. *)

val passes : t -> Rat.t -> Rat.t -> bool
(** [passes f x y] is true if f(x) = y. It needs no division. *)

val slope : t -> Polynomial.t
(** [slope f] is a polynomial that has the sign of the derivative of [f] wherever [f] has no pole. *)

val derivative : t -> t
(** [derivative f] is the derivative of [f]. *)

val compare : t -> t -> int
(** A total order of functions, by their coefficients. It is 0 exactly for equal functions. *)

val equal : t -> t -> bool
(** [equal f g] is true if both are the same function. *)

val hash : t -> int
(** A hash that is equal for equal functions. *)

val bits : t -> int
(** [bits f] is the number of bits of all coefficients. *)

val to_string : variable:string -> t -> string
(** [to_string ~variable f] is e.g. ["(k^2 - 3)/(2k + 1)"], ["(1/2)k + 1"] or ["2/3"]. *)
