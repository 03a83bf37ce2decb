(** Intervals that are right for the normal distribution, and so nearly for a mean of many runs. Nothing bounds
    their error: a value too rare to be among the runs may move the mean by any amount (rule Normal). *)

open Scc_exact

val quantile : Rat.t -> Rat.t
(** [quantile miss] is the least z, on nine digits, for which a normal number is more than z standard deviations
    from its mean with at most the probability [miss]. [miss] is less than 1, and at least {!least_miss} (it is 10
    otherwise). *)

val least_miss : Rat.t
(** 10{^-20}. *)

val needed : int
(** 30: so many runs must have another value than the most frequent one. Otherwise the spread of the values is not
    known well enough; it may even be 0. *)

val others : Tally.t -> int
(** [others t] is the number of runs that have another value than the most frequent one. *)

val interval : Tally.t -> miss:Rat.t -> (Rat.t * Rat.t) option
(** [interval t ~miss] is the mean of the runs, and how far from it the ends of the interval are. [None] if
    {!others} are fewer than {!needed}, or [miss] is less than {!least_miss}. *)
