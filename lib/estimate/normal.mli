(** The normal distribution. *)

open Scc_exact

val two_sided : Rat.t -> Rat.t
(** For a confidence c < 1: a number z such that a standard normal number is from -z to z with the probability c or
    more; the least multiple of 1/1000 for which this is proved. At most 20. *)
