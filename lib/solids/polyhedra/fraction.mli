(** The simplest fraction of an open interval. *)

open Scc_exact

val simplest : above:Rat.t option -> below:Rat.t option -> Rat.t
(** [simplest ~above ~below] is the number strictly between the bounds with the least denominator. Among
    several it is the one nearest to 0, and of two such the positive one. A bound may be missing; an empty
    interval is a bug. *)
