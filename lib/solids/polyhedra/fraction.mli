(** The simplest fraction of a range. *)

open Scc_exact

val simplest : above:Rat.t option -> below:Rat.t option -> Rat.t
(** Of the numbers strictly between the bounds, each of which may be missing, that of the least denominator; of
    several the one nearest to 0, and of two the positive one. The range is not empty. *)
