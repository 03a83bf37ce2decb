(** Numbers as texts of the language. *)

open Scc_exact

val number : Rat.t -> string
(** [number q] is a text that reads back as [q]: a decimal if there is a finite one, otherwise ["p/q"]. Every
    number of a source text has a finite decimal. *)

val decimal : Rat.t -> string option
(** [decimal q] is the finite decimal of [q >= 0], with an exponent if that is much shorter. It is [None] if [q]
    has no finite decimal. *)

val power_of_two : Rat.t -> string option
(** [power_of_two q] is ["2^-k"] if [q] is 2^-k for some k > 0, and [None] otherwise. *)
