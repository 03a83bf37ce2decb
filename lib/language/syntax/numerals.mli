(** Numbers as they are written. *)

open Scc_exact

val number : Rat.t -> string
(** Reads back as the same number: a decimal where there is one (every number of a source text is), else
    ["p/q"]. *)

val decimal : Rat.t -> string option
(** Of a number that is not negative; [None]: it has no end. *)

val power_of_two : Rat.t -> string option
(** ["2^-k"] of 2^-k, for k > 0. *)
