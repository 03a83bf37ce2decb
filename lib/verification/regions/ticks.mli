(** The marks of an axis. *)

open Scc_exact
open Scc_calculus

type mark = { at : Rat.t; label : string; exact : string  (** the number *) }

val marks : Ranges.range -> mark list
(** Multiples of 1, 2 or 5 times a power of 10, about four to eight, with short decimals. If those are not
    short, the marks are the two ends, as ["low"] and ["high"]. *)
