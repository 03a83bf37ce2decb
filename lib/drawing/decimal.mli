(** Decimals for people: short, and so rounded as a rule. Computed from rationals without floats. *)

open Scc_exact

val fixed : places:int -> Rat.t -> string
(** Rounded to so many places after the point; zeros at the end are left out: ["12.35"], ["-3"], ["0"]. *)

val significant : digits:int -> Rat.t -> string
(** Rounded to so many digits from the first that is not 0 on: ["0.1667"], ["1.5e-300"]; zeros at the end are left
    out. *)

val significant_above : digits:int -> Rat.t -> string
(** The same of a number >= 0, rounded up. *)

val exact : Rat.t -> string option
(** All digits, of a number that has finitely many and needs no more than twelve places: [Some "0.125"], [None] for
    1/3. *)

val order_of_magnitude : Rat.t -> int
(** The greatest n with 10{^n} <= x, for x > 0. *)
