(** Networks as a timed transition system over tuples, for the explorer. The transitions of single processes and
    of pairs are computed once and cached. So a transition that concerns few processes of a large network costs
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
  ?joined:bool ->
  ?units:Course_units.t list ->
  ?memory:int ->
  ?few:int ->
  Semantics.t -> State.t -> context
(** [make c initial] is the system that starts from [initial], a result of {!Scc_semantics.Network.initial}.
    - [events] mark states: the tuple has the set of those that have just led to the state. By default there are
      none.
    - [time_seen] is the absolute times that states are distinguished by, if they have time; by default all of
      them.
    - [quotient] is an equivalence: each state stands for its class. By default all states are distinguished.
    - [visible] is true for the leaves that the formulas depend on. With it, independent events of one instant
      that no formula depends on are made in one order only ({!reduced}).
    - [joined], by default false, makes the draws and lots of one instant one transition (rule JoinedDraws). It has
      no effect if there are [events], or if bodies turn.
    - [units] is what formulas see of bodies that move between two draws; all other states of one step of walkers
      are one (rule JoinedDraws). By default all are distinguished. It has no effect without [joined], and needs
      {!Quotient.t.forgets}.
    - [memory], a power of two, bounds each cache. It changes nothing but the speed.
    - [few] is a number of basic shapes, by default 32. In models with no more, all pairs are compared in each
      state. It changes nothing but the speed. *)

val arrived : context -> Property.event -> int array -> bool
(** [arrived c event] is true for a state if the transition that has just led to it matches [event], one of those
    of {!make}. Applied to [c] and [event] alone, it finds the event in their list once. *)

val events_of_mark : context -> int -> int list
(** The events of a mark ({!Catalogue.mark_slot}), as increasing indices into {!events}. *)

val mark_of : context -> int list -> int
(** The mark of some events, given as increasing indices into {!events}. *)

val events : context -> Property.event list
(** The events that mark states, as given to {!make}. *)

val happened : context -> int array -> int list
(** The events that have just led to a state, as increasing indices into {!events}. *)

val set_happened : context -> int array -> int list -> unit
(** [set_happened c tuple places] writes into [tuple] the mark of the events with these indices. *)

val catalogue : context -> Catalogue.t
(** The numbers of all components. *)

val semantics : context -> Semantics.t
(** The semantics of the model. *)

val model : context -> Model.t
(** The model. *)

val start : context -> State.t
(** The initial state. *)

val codec : context -> Scc_codec.State_codec.t
(** The codec for the states of the model that are reachable from the initial one. *)

val split_step : context -> Rat.t option
(** The split step, if a weak split or a lot has come up in a state found so far; else [None], and also with
    [Model.Any_time]. In the calculus weak splits may happen at any time between split instants as well (reading
    I-9). *)

val given_up : context -> Transition.fault list
(** The faults at dead ends found so far, each once (rules Run and Persistent). {!successors} of a dead end is
    empty. *)

val is_dead_end : Semantics.t -> State.t -> bool
(** [is_dead_end c s] is true if the successors of [s] are a persistent contact (rule Persistent). *)

val representative : context -> int array -> int array
(** The representative of a state in its class modulo the quotient. Events may lead from a representative to
    states that are none, if {!Quotient.t.drift} finds that more bodies are apart for ever. *)

val draws_towards : context -> State.t -> int array -> (int * Vec.t) list option
(** [draws_towards c s target] is the first leaves of the walkers that wait to draw in [s], and the velocities
    that they draw so that the state after them has the representative [target]. It is [None] where this is to be
    searched. *)

val names_differ : context -> bool
(** [names_differ c] is true if a state of the graph may have other names of leaves than the states that it stands
    for. *)

val same_but_for_places : context -> State.t -> State.t -> bool
(** [same_but_for_places c s t] is {!Quotient.same_but_for_places} of the two states. *)

val keeps : context -> int array -> Property.quantity -> bool
(** [keeps c tuple q] is {!Quotient.keeps} of the state. *)

val choices : context -> State.t -> ((Transition.t * int array Lazy.t) list, Transition.fault) result
(** Every transition of a state by the rules ([Network.successors]), each with the representative tuple of its
    target. *)

include Scc_graph_search.Lts.S with type context := context and type fault = Transition.fault
