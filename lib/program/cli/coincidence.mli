(** Summands that differ in their chance alone, and are the same term for some value of a parameter.

    A bond that was to be released by a summand stays so if its end still offers the same term after another
    release (rule Lot). So at such a value the model has other transitions than at the values around it. *)

open Scc_calculus

val find : Model.t -> State.t -> Ranges.range -> (string * Odds.t * Odds.t) option
(** [find m declared range] is a value of the parameter strictly within the range, as ["k = 1/2"], at which the
    chances of two summands are equal, and these chances. One of the summands is offered beside another one with a
    chance, and the second one after that. Otherwise both have the same channel, push and continuation. *)
