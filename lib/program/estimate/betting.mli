(** Lower bounds of means, from samples of numbers that are never negative (law {e Betting} of the rule book). *)

open Scc_exact

val lower : (Rat.t * int) list -> runs:int -> miss:Rat.t -> Rat.t
(** [lower values ~runs ~miss] is a lower bound of a mean after [runs] independent runs. [values] are the numbers
    of runs, each once and more than 0, with the number of runs that have it; all other runs have 0. Let a sample
    grow without end, and let a bound be computed after each run. Then some of all these bounds is above the mean
    with at most the probability [miss]. The bound has ten digits, and is the greatest one of so many digits for
    which this is proved, but for rounding. *)
