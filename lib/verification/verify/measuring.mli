(** Questions for numbers, answered on an explored graph (rules Probability, Expectation). *)

open Scc_property
open Scc_state_space

val probability : Unsettled.t -> Temporal.t -> int -> Property.side list -> Verdict.t
(** Of what the formula of this index says of a run. *)

val mean :
  Unsettled.t -> Temporal.t -> int -> Property.side list -> Property.mean -> Scc_chance.Answer.bound option ->
  Verdict.t
(** The formula of the index is that of the check. Compared with a bound, it holds or not. *)

val intervals : Temporal.t -> int -> Verdict.reason list
(** What is known of the probabilities that an undecided formula depends on at once. *)
