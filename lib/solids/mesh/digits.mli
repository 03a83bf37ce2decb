(** Rational numbers as decimals, for programs that read no fractions. *)

open Scc_exact

val exact : Rat.t -> string option
(** The number as a decimal without an exponent, in the fewest digits, as {!Mesh.read} and other programs read
    it. [None] if there is no such decimal, as for 1/3, or none of at most {!Text.max_digits} digits. *)

val rounded : Rat.t -> Rat.t option
(** The nearest 64-bit floating-point number; [None] beyond the greatest. *)
