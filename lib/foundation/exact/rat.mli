(** Rationals: Zarith's [Q] with what the rest of scc needs. All values are finite: no function here
    makes or takes the infinities of [Q]. *)

type t = Q.t

val zero : t
val one : t
val of_int : int -> t

val make : Z.t -> Z.t -> t
(** [make n d] is n/d in lowest terms; [d] is not zero. *)

val add : t -> t -> t
val sub : t -> t -> t
val mul : t -> t -> t

val div : t -> t -> t
(** The divisor is not zero. *)

val neg : t -> t
val abs : t -> t
val min : t -> t -> t
val max : t -> t -> t
val sign : t -> int
val equal : t -> t -> bool
val compare : t -> t -> int
val hash : t -> int
val is_integer : t -> bool

val floor : t -> Z.t
(** The greatest integer at most the number. *)

val round_to : t -> quantum:t -> t
(** [round_to x ~quantum] is the multiple of [quantum] (positive) nearest to [x]; of two, the one farther
    from zero. *)

val modulo : t -> t -> t
(** [modulo x m] is x - m floor(x/m), in [0, m), for positive [m]. *)

val to_string : t -> string
(** ["p/q"] in lowest terms, or ["p"] when q = 1. *)

val to_float : t -> float
(** The nearest float (lossy: for people and for filters, never for a decision). *)

val is_float : t -> bool
(** Whether {!to_float} is the number itself, as far as that is seen at once: of numbers of at most 2{^53} over a
    power of two that is an [int]. *)

val near_float : t -> float
(** A float within 3 * 2^-53 of the number, relatively, unless that is too great or too small for a float: faster
    than {!to_float} for long numbers. *)

val bits : t -> int
(** Bits of numerator and denominator together: how much the number has grown. *)

val max_digits : int
(** A literal may have at most this many digits, written out (exponents included): 4 000. *)

type literal_error = Malformed | Too_large | Zero_denominator

val of_literal : string -> (t, literal_error) result
(** Reads ["3"], ["0.125"], ["1e-3"], ["-1/4"], ["+2"]: exact. [Too_large] is found before the number is
    built. *)

val short_above : t -> t
(** A number >= 0, rounded up to ten bits or one more. *)

val root : t -> t
(** The square root of a number >= 0, if that is rational; else more than it by less than two in forty bits. *)

val sqrt_above : Z.t -> Z.t -> t
(** [sqrt_above n d], for n >= 0 and d > 0: at least the square root of n/d, and more by less than two in ten bits;
    a short number. *)
