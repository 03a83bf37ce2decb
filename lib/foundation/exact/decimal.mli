(** Decimals for people: short, and so rounded as a rule, always to the nearest; of two, to the one farther from
    zero. Computed from rationals without floats, so that a number of any size has its digits. *)

val fixed : places:int -> Rat.t -> string
(** Rounded to so many places after the point; zeros at the end are left out: ["12.35"], ["-3"], ["0"]. *)

val padded : places:int -> Rat.t -> string
(** The same with these zeros: ["12.350000"]. *)

val significant : digits:int -> Rat.t -> string
(** Rounded to so many digits from the first that is not 0 on: ["0.1667"], ["1.5e-300"]; zeros at the end are left
    out. *)

val significant_above : digits:int -> Rat.t -> string
(** The same of a number >= 0, rounded up. *)

val marked : Rat.t -> string
(** ["~"] and six places after the point, or seven digits and a power of ten below 1/1000 and from 10{^9} on:
    ["~0.333333"], ["~-2.000000e9"]. The number itself is at most half a unit of the last digit away from it. Where
    it is that very number, there is no ["~"], and no zeros at the end: ["0.5"], ["1e60"]. *)

val exact : Rat.t -> string option
(** All digits, of a number that has finitely many and needs no more than twelve places: [Some "0.125"], [None] for
    1/3. *)

val order_of_magnitude : Rat.t -> int
(** The greatest n with 10{^n} <= x, for x > 0. *)
