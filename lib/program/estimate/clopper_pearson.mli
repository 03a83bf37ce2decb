(** Intervals for the probability of a success, from the number of trials that succeeded (Clopper and Pearson,
    1934). *)

open Scc_exact

val unit : Rat.t
(** The resolution of intervals: their ends are multiples of 10^-6. *)

val lower : n:int -> k:int -> miss:Rat.t -> Rat.t
(** [lower ~n ~k ~miss] is a lower bound of the probability after [k] successes in [n] trials. Whatever the
    probability is, the bound is above it with at most the probability [miss], which is less than 1/2. It is the
    greatest one for which this is proved, rounded down. *)

val upper : n:int -> k:int -> miss:Rat.t -> Rat.t
(** [upper ~n ~k ~miss] is an upper bound, likewise: it is below the probability with at most the probability
    [miss]. *)
