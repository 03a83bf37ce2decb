(** Rationals: Zarith's [Q] with what the rest of scc needs. All values are finite: no function here
    makes or takes the infinities of [Q]. *)

type t = Q.t

val zero : t
(** The number 0. *)

val one : t
(** The number 1. *)

val half : t
(** The number 1/2. *)

val of_int : int -> t
(** [of_int n] is the integer [n]. *)

val make : Z.t -> Z.t -> t
(** [make n d] is n/d in lowest terms; [d] is not zero. *)

val add : t -> t -> t
(** [add x y] is x + y. *)

val sub : t -> t -> t
(** [sub x y] is x - y. *)

val mul : t -> t -> t
(** [mul x y] is x y. *)

val div : t -> t -> t
(** [div x y] is x/y. The divisor is not zero (a bug otherwise). *)

val neg : t -> t
(** [neg x] is -x. *)

val abs : t -> t
(** [abs x] is the magnitude |x|. *)

val min : t -> t -> t
(** [min x y] is the lesser of the two numbers. *)

val max : t -> t -> t
(** [max x y] is the greater of the two numbers. *)

val middle : t -> t -> t
(** [middle x y] is (x + y)/2. *)

val span : t -> t list -> t * t
(** [span x rest] is the least and the greatest of [x] and the numbers of [rest]. *)

val sign : t -> int
(** [sign x] is -1, 0 or 1. *)

val equal : t -> t -> bool
(** [equal x y] is true if the numbers are equal. *)

val compare : t -> t -> int
(** The order of the rational numbers. *)

val hash : t -> int
(** A hash that is equal for equal numbers. *)

val is_integer : t -> bool
(** [is_integer x] is true if the denominator is 1. *)

val floor : t -> Z.t
(** [floor x] is the greatest integer that is at most [x]. *)

val round_to : t -> quantum:t -> t
(** [round_to x ~quantum] is the multiple of [quantum] nearest to [x]; halves are rounded away from zero. [quantum]
    is positive. *)

val modulo : t -> t -> t
(** [modulo x m] is x - m floor(x/m), at least 0 and less than [m], for positive [m]. *)

val to_string : t -> string
(** [to_string x] is ["p/q"] in lowest terms, or ["p"] if q = 1. *)

val to_float : t -> float
(** [to_float x] is the nearest float. It is lossy: for people and for filters, never for a decision. *)

val is_float : t -> bool
(** [is_float x] is true if a quick check shows that {!to_float} is exact: the numerator is at most 2{^53} in
    magnitude, and the denominator is a power of two that fits an [int]. *)

val near_float : t -> float
(** [near_float x] is a float with a relative error of at most 3 * 2^-53, unless [x] is too great or too small for
    a float. It is faster than {!to_float} for long numbers. *)

val power_of_two : int -> t
(** [power_of_two k] is 2{^k}, for any [k]. *)

val bits : t -> int
(** [bits x] is the number of bits of numerator and denominator together. *)

val max_digits : int
(** 4 000: the greatest number of digits of a literal, with its power of ten written out. It holds for
    the numerator and the denominator of a fraction each. *)

type literal_error = Malformed | Too_large | Zero_denominator

val of_literal : string -> (t, literal_error) result
(** [of_literal text] is the exact value of ["3"], ["0.125"], ["1e-3"], ["-1/4"] or ["+2"]. [Too_large] (beyond
    {!max_digits}) is found before the number is built. *)

val short_above : t -> t
(** [short_above x] is [x] rounded up to ten or eleven bits, for [x >= 0]. *)

val root : t -> t
(** [root x], for [x >= 0], is the square root if it is rational. Otherwise it is greater than the square root, by
    less than two units in the last of forty bits. *)

val root_to : bits:int -> t -> t
(** [root_to ~bits x] is {!root} with this number of bits, at least 1, in the place of forty. *)

val log_above : t -> int
(** [log_above x] is the least integer k >= 0, or the one after it, with |x| < 2{^k}. *)

val sqrt_above : Z.t -> Z.t -> t
(** [sqrt_above n d], for n >= 0 and d > 0, is a short number that is at least the square root of n/d. It exceeds
    the root by less than two units in the last of ten bits. *)
