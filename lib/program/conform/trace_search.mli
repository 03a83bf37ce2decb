(** The runs of a model to which a recorded trace can belong. The items of the trace are met one after the
    other, and the search keeps the set of all states in which the model can then be.

    Time passes by itself between events. A recorded event is met by a transition with a label that fits, at a
    time that differs by at most the tolerance. It may be met before events that were recorded earlier, if those
    are also met within the tolerance and no process takes part in both. So near-simultaneous events of separate
    bodies may be recorded in either order. Every event of the model must be recorded, unless it is
    unobserved. *)

open Scc_exact
open Scc_calculus
open Scc_semantics

(** Where a search is given up. *)
type limits = {
  states : int;  (** the greatest number of states examined for one item of the trace *)
  stop : unit -> Scc_graph_search.Limits.stop option;  (** why it is to end now, if it is *)
}

val default_states : int
(** The default of [limits.states]: 20 000. *)

(** A run that the trace so far can record. *)
type hypothesis = {
  state : State.t;
  time : Rat.t;
  next : int;  (** the index of the first item that is not met *)
  ahead : Burst.event list;  (** later items that are met, in the order of the trace *)
  choices : (int * string) list;  (** numbers and labels of the transitions, the latest first *)
  last : (Transition.label * Rule.t list * Rat.t) option;  (** the latest transition with its time *)
  deviation : Against.deviation;
  transitions : (Transition.t list, Transition.fault) result Lazy.t;  (** of the state *)
  untold : untold option;  (** releases of the latest transition that are left, if recorded one by one *)
}

(** Bonds that were released at once, and the hypothesis before. *)
and untold = { before : hypothesis; labels : Transition.label list }

(** A transition that is possible in a hypothesis. *)
type possible = { from : hypothesis; taken : Transition.t }

(** A state of the trace that does not fit a hypothesis. *)
type misfit = { of_ : hypothesis; differences : Against.difference list }

(** Where no hypothesis meets a further item. *)
type dead_end = {
  reached : hypothesis list;  (** all that were examined since the last item was met *)
  possible : possible list;  (** events *)
  misfits : misfit list;
}

(** The result of a search. *)
type outcome =
  | Met of { run : hypothesis; widest : int  (** the greatest number of hypotheses at once *) }
  | Dead_end of dead_end
  | Unknown of { reason : reason; items : int  (** the number of items that were met *) }

and reason =
  | Too_many_states
  | Fault of Transition.fault  (** some transitions, which might have met it, cannot be computed *)
  | Stopped of Scc_graph_search.Limits.stop

val run :
  Against.t ->
  Recorded.t ->
  State.t ->
  observed:(Transition.label -> bool) ->
  limits ->
  (outcome, Transition.fault) result
(** Searches from the declared state. [observed] is true for the labels of events that must be recorded. *)

val urgent : Transition.t -> bool
(** [urgent t] is true if no time passes while [t] is possible: {!Scc_semantics.Transition.is_urgent}. *)

val beyond : Against.t -> State.t -> Rat.t -> steps:int -> (State.t * Rat.t) list
(** [beyond t s time ~steps] is the states after [s], which is at [time], that are reached by the passing of
    time and by lots alone. There are at most [steps] of them, in the order of time, with their times. *)
