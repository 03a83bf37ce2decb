(** Intervals for the probability of a success, from how many trials succeeded (Clopper and Pearson, 1934). *)

open Scc_exact

val unit : Rat.t
(** The ends of intervals are multiples of it: 10^-6. *)

val lower : n:int -> k:int -> miss:Rat.t -> Rat.t
(** When k of n trials have succeeded: a number such that, whatever the probability, it is above it with at most
    the probability [miss], which is less than 1/2. It is the greatest for which this is proved, rounded down. *)

val upper : n:int -> k:int -> miss:Rat.t -> Rat.t
(** Likewise, below it. *)
