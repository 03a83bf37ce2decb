(** Numbers and truths over time, from a state on, as exact pieces: functions of the time since that state.

    An object with the coefficients of a numerator and a denominator, or with the reason why there is no number;
    where it changes in between, several of them with where each begins. What is so at a single instant alone has a
    piece of its own, and the next one begins where it does. Instants that are not rational are told by a rational
    at most 10^-12 before them. *)

open Scc_ctl
open Scc_evaluate

val number : Value.t Timeline.t -> Json.t

val truth : Truth.t Timeline.t -> Json.t
(** As the numbers 1 and 0, with the reason where it is undecided. *)
