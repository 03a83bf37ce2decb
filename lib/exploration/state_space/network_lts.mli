(** Networks as a timed transition system over tuples, for the explorer. What a process may do alone, and two by
    themselves, is computed once and remembered, so that a transition in a corner of a large network costs
    little. *)

open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_property

type context

val make :
  ?events:Property.event list ->
  ?time_seen:Time_seen.t ->
  ?quotient:Quotient.t ->
  ?visible:(int -> bool) ->
  ?memory:int ->
  ?few:int ->
  Semantics.t -> State.t -> context
(** With the initial state, as {!Network.initial} gives it. States are told apart by which of the events has
    just led to them, and by as much of absolute time as is seen ([Always] by default, where states have it).
    States stand for all that are equal modulo the [quotient]. With [visible], which leaves
    can be seen by what is asked, independent events of one instant that cannot be seen are made in one order
    only ({!reduced}). [memory], a power of two, bounds how many results are remembered of each kind, and with at
    most [few] basic shapes (32) all pairs are looked at in each state: both change nothing but the speed. *)

val arrived : context -> Property.event -> int array -> bool
(** Whether the transition that has just led to the state was of the event, one of those of {!make}. The event, of
    which there may be many, is looked for once. *)

val events_of_mark : context -> int -> int list
(** The places of the events that a mark stands for ({!Catalogue.mark_slot}). *)

val mark_of : context -> int list -> int
(** The mark of some events, by their places, increasing. *)

val events : context -> Property.event list
(** Those of {!make}. *)

val happened : context -> int array -> int list
(** Their places in the list, in order, of those that have just led to the state. *)

val set_happened : context -> int array -> int list -> unit

val catalogue : context -> Catalogue.t
val semantics : context -> Semantics.t
val model : context -> Model.t
val start : context -> State.t

val codec : context -> Scc_codec.State_codec.t
(** Of the states of the model. *)

val split_step : context -> Rat.t option
(** Between the instants at which weak splits were looked at, when one has been enabled in a state found so far: in
    the calculus they may happen at any time between them as well (reading I-9). *)

val given_up : context -> Transition.fault list
(** Why runs end in dead ends of what has been explored so far (rules Run and Persistent): {!successors} finds no
    transitions there. *)

val is_dead_end : Semantics.t -> State.t -> bool

val representative : context -> int array -> int array
(** The state that stands for one, and for all that are equal to it modulo the quotient. Events lead from it to
    states that need not be their own representatives, where {!Quotient.t.drift} finds that more bodies are apart
    for ever. *)

val same_but_for_places : context -> State.t -> State.t -> bool
(** {!Quotient.same_but_for_places}. *)

val keeps : context -> int array -> Property.quantity -> bool
(** {!Quotient.keeps}. *)

val choices : context -> State.t -> ((Transition.t * int array Lazy.t) list, Transition.fault) result
(** Every transition of a state by the rules ({!Network.successors}), each with the tuple of where it leads. *)

include Scc_graph_search.Lts.S with type context := context and type fault = Transition.fault
