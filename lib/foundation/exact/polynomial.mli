(** Polynomials in one variable over the rationals, with exact isolation of their real roots. In scc the
    variable is the time since the start of a time transition. *)

type t
(** A polynomial in canonical form: the leading coefficient is not zero. *)

val zero : t
(** The polynomial 0. *)

val one : t
(** The constant polynomial 1. *)

val variable : t
(** The polynomial t. *)

val constant : Rat.t -> t
(** [constant c] is the constant polynomial c. *)

val of_coefficients : Rat.t list -> t
(** [of_coefficients [c0; c1; c2]] is c0 + c1 t + c2 t^2. *)

val coefficients : t -> Rat.t list
(** [coefficients p] is the coefficients from the constant one up; the last is not zero. It is [[]] for the zero
    polynomial. *)

val degree : t -> int
(** [degree p] is the greatest exponent; -1 for the zero polynomial. *)

val is_zero : t -> bool
(** [is_zero p] is true for the zero polynomial. *)

val to_constant : t -> Rat.t option
(** [to_constant p] is the value of a constant polynomial; [None] if the degree is at least 1. *)

val add : t -> t -> t
(** [add p q] is p + q. *)

val sub : t -> t -> t
(** [sub p q] is p - q. *)

val neg : t -> t
(** [neg p] is -p. *)

val mul : t -> t -> t
(** [mul p q] is p q. *)

val scale : Rat.t -> t -> t
(** [scale k p] is k p. *)

val eval : t -> Rat.t -> Rat.t
(** [eval p x] is the exact value p(x). *)

val sign_at : t -> Rat.t -> int
(** [sign_at p x] is the sign of p(x): -1, 0 or 1. *)

val equal : t -> t -> bool
(** [equal p q] is true if all coefficients are equal. *)

val derivative : t -> t
(** [derivative p] is the derivative of [p]. *)

val divide : t -> t -> t * t
(** [divide a b] is [(q, r)] with a = q b + r and degree r < degree b. [b] is not zero (a bug otherwise). *)

val primitive : t -> t
(** [primitive p] is the positive multiple of [p] whose coefficients are integers without a common factor; zero for
    zero. *)

val gcd : t -> t -> t
(** [gcd p q] is the greatest common divisor that is primitive with a positive leading coefficient; zero if both
    are zero. *)

val square_free : t -> t
(** [square_free p] is a primitive polynomial with the same roots as [p], each of them simple. *)

val odd_part : t -> t
(** [odd_part p] is a primitive polynomial with simple roots, which has the sign of [p] at all points but finitely
    many. Its roots are those at which [p] changes sign. It is zero for zero. *)

val substitute : t -> scale:Rat.t -> shift:Rat.t -> t
(** [substitute p ~scale ~shift] is p(scale t + shift). *)

(** {1 Counting roots: Sturm's theorem} *)

type sturm
(** A Sturm chain. *)

val sturm : t -> sturm
(** [sturm p] is the Sturm chain of a square-free polynomial [p] that is not zero. *)

val count : sturm -> Rat.t -> Rat.t -> int
(** [count c a b] for a <= b is the number of roots x with a < x <= b. *)

(** {1 Isolating roots} *)

type root =
  | Exactly of Rat.t
  | Within of { polynomial : t; low : Rat.t; high : Rat.t }
  (** The only root of a square-free primitive polynomial in the open interval (low, high). It is irrational, and
      the polynomial vanishes at neither end. *)

val roots : t -> low:Rat.t -> high:Rat.t option -> root list
(** [roots p ~low ~high] is the real roots of [p] in the open interval (low, high), each once, increasing; [high =
    None] is infinity. [p] is not zero (a bug otherwise). *)

val isolated : t -> low:Rat.t -> high:Rat.t -> root
(** [isolated p ~low ~high] is the only root of [p] in the open interval (low, high). At the ends [p] has opposite
    signs, neither of them 0. *)

val to_string : ?variable:string -> t -> string
(** [to_string p] is e.g. ["2t^2 - 3"]; the variable is ["t"] by default. *)
