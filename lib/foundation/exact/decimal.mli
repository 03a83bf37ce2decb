(** Decimals for people: short, and rounded to the nearest; of two equally near ones, to the one farther from zero.
    They are computed from rationals without floats, so that the digits of a number of any size are right. *)

val fixed : places:int -> Rat.t -> string
(** [fixed ~places x] is [x] rounded to [places] places after the point, without zeros at the end: ["12.35"],
    ["-3"], ["0"]. *)

val rounded_down : places:int -> Rat.t -> string
(** [rounded_down ~places x] is the greatest decimal with [places] places after the point that is at most [x],
    without zeros at the end, as {!fixed} writes it. *)

val rounded_up : places:int -> Rat.t -> string
(** [rounded_up ~places x] is the least decimal with [places] places after the point that is at least [x]. *)

val padded : places:int -> Rat.t -> string
(** [padded ~places x] is [x] rounded to [places] places after the point, with zeros at the end: ["12.350000"]. *)

val significant : digits:int -> Rat.t -> string
(** [significant ~digits x] is [x] rounded to [digits] digits from the first that is not 0 on, without zeros at the
    end of a fraction: ["0.1667"], ["1.5e-300"]. It has a power of ten below 10{^-5} and from 10{^9} on. *)

val significant_above : digits:int -> Rat.t -> string
(** [significant_above ~digits x] is as {!significant}, but rounded up. [x] is at least 0 (a bug otherwise). *)

val in_short : most:int -> Rat.t -> string
(** [in_short ~most x] is {!Rat.to_string} if that has at most [most] bytes. Otherwise it is ["about"] and [x]
    rounded to 6 digits. *)

val marked : Rat.t -> string
(** [marked x] is ["~"] and [x] with six places after the point, or with seven digits and a power of ten below
    1/1000 and from 10{^9} on: ["~0.333333"], ["~-2.000000e9"]. The error is at most half a unit of the last digit.
    A text that is exact has no ["~"], and no zeros at the end: ["0.5"], ["1e60"]. *)

val exact : Rat.t -> string option
(** [exact x] is all digits of [x], if it has at most twelve places after the point: [Some "0.125"], but [None] for
    1/3. *)

val order_of_magnitude : Rat.t -> int
(** [order_of_magnitude x] is the greatest n with 10{^n} <= x, for x > 0. *)
