(** Rational numbers as decimals, for programs that read no fractions. *)

open Scc_exact

val exact : Rat.t -> string option
(** Without an exponent, in the fewest digits, as {!Mesh.read} and every other program reads it. [None] when there
    is no such decimal, as for 1/3, or none of at most {!Text.max_digits} digits. *)

val rounded : Rat.t -> Rat.t option
(** The nearest 64-bit number; [None] beyond the greatest. *)
