(** Polynomials in one variable over the rationals, with exact isolation of their real roots. In scc the
    variable is the time since the start of a time transition. *)

type t
(** Always in canonical form: equal polynomials have equal coefficients. *)

val zero : t
val one : t

val variable : t
(** The polynomial t. *)

val constant : Rat.t -> t

val of_coefficients : Rat.t list -> t
(** [of_coefficients [c0; c1; c2]] is c0 + c1 t + c2 t^2. *)

val coefficients : t -> Rat.t list
(** From the constant one up; the last is not zero. [[]] for the zero polynomial. *)

val degree : t -> int
(** -1 for the zero polynomial. *)

val is_zero : t -> bool

val to_constant : t -> Rat.t option
(** The value of a constant polynomial. *)

val add : t -> t -> t
val sub : t -> t -> t
val neg : t -> t
val mul : t -> t -> t
val scale : Rat.t -> t -> t
val derivative : t -> t
val eval : t -> Rat.t -> Rat.t

val sign_at : t -> Rat.t -> int
(** The sign of the value: -1, 0 or 1. *)

val equal : t -> t -> bool

val divide : t -> t -> t * t
(** [divide a b] is [(q, r)] with a = q b + r and degree r < degree b; [b] is not zero. *)

val primitive : t -> t
(** The positive multiple whose coefficients are integers without a common factor. *)

val gcd : t -> t -> t
(** A greatest common divisor, primitive with a positive leading coefficient; zero when both are zero. *)

val square_free : t -> t
(** A primitive polynomial with the same roots, each of them simple. *)

val odd_part : t -> t
(** A primitive polynomial, with simple roots only, that has the same sign everywhere but at finitely many
    points: its roots are those at which the polynomial changes sign. Zero for zero. *)

val substitute : t -> scale:Rat.t -> shift:Rat.t -> t
(** [substitute p ~scale ~shift] is p(scale t + shift). *)

val root_bound : t -> Rat.t
(** A positive bound that every real root of a non-zero polynomial is strictly below, in magnitude. *)

(** {1 Counting roots: Sturm's theorem} *)

type sturm
(** A Sturm chain. *)

val sturm : t -> sturm
(** Of a square-free polynomial that is not zero. *)

val count : sturm -> Rat.t -> Rat.t -> int
(** [count c a b] for a <= b is the number of roots in (a, b]. *)

(** {1 Isolating roots} *)

type root =
  | Exactly of Rat.t
  | Within of { polynomial : t; low : Rat.t; high : Rat.t }
  (** The irrational root of a square-free primitive polynomial that is alone in the open interval; the
      polynomial vanishes at neither end. *)

val roots : t -> low:Rat.t -> high:Rat.t option -> root list
(** The real roots in the open interval (low, high), each once, increasing; [high = None] is infinity. The
    polynomial is not zero (a bug otherwise). *)

val isolated : t -> low:Rat.t -> high:Rat.t -> root
(** The root in the open interval (low, high) of a polynomial that has one only there, and has different signs, not
    zero, at the ends. *)

val to_string : ?variable:string -> t -> string
(** E.g. ["2t^2 - 3"]. *)
