(** Tails of the binomial distribution, bounded from above: numbers have 192 binary digits, and every operation is
    rounded up. *)

open Scc_exact

type coefficient
(** Of n and k, made once for all chances. *)

val coefficient : n:int -> k:int -> coefficient
(** 0 <= k <= n. *)

val at_most : coefficient -> chance:Rat.t -> Rat.t -> bool
(** Whether it is proved that of n trials that succeed with this probability, from 0 to 1, at least k do so with a
    probability of at most the number, which is less than 1/2. *)
