(** What is known before an exploration ends: the time after which no check looks, and the graphs on which all of
    them are settled (rule Settling). *)

open Scc_exact
open Scc_calculus
open Scc_property
open Scc_graph_search
open Scc_state_space

val horizon : Model.t -> initial:State.t -> Property.check list -> Rat.t option
(** [horizon m ~initial checks] is the model time from the initial state after which no state has to be expanded
    for the checks. The result is [None] if there is no such bound, or if there are no checks. *)

val within : Model.t -> initial:State.t -> Rat.t option -> Property.prop -> Rat.t option
(** [within m ~initial bound goal] is the bound of a search for [goal]: [bound], or the model time from the initial
    state after which the goal is false for good, if that is less. *)

type question = { asked : Property.asked; formula : int  (** its number in {!Scc_state_space.Temporal.ask} *) }

val settled :
  Limits.surroundings -> Temporal.asked -> rests:(int array -> bool) -> question list ->
  (State_graph.t -> bool) option
(** [settled around formulas ~rests questions] is a test of one graph while it grows. It is true if no further
    state can change the answer to any of the questions: each formula has its truth, and no state that was not
    expanded matters to a number. The result is [None] if there are no questions. *)
