(** The runs of a model that a recorded trace can be of. The items of the trace are met one after the other, and
    the set of all states that the model can then be in is kept.

    Time passes by itself between events. A recorded event is met by a transition with a label that fits, at a time
    that differs by at most the tolerance. It may be met before events that were recorded earlier, if those are met
    within the tolerance as well and no process takes part in both: near-simultaneous events of separate bodies may
    have been recorded in either order. Every event of the model has to be recorded, unless it is unobserved. *)

open Scc_exact
open Scc_calculus
open Scc_semantics

type limits = {
  states : int;  (** looked at for one item of the trace, at most *)
  interrupted : unit -> bool;
}

val default_states : int

(** One way in which the trace can be what happened so far. *)
type hypothesis = {
  state : State.t;
  time : Rat.t;
  next : int;  (** the first item that is not met *)
  ahead : Burst.event list;  (** later ones that are, in the order of the trace *)
  choices : (int * string) list;  (** numbers and labels of the transitions, the latest first *)
  last : (Transition.label * Rule.t list * Rat.t) option;  (** the latest transition, and when *)
  deviation : Against.deviation;
  transitions : (Transition.t list, Transition.fault) result Lazy.t;  (** of the state *)
  untold : untold option;  (** what the latest transition did beside what has been met, if it is told one by one *)
}

(** Bonds that were released at once, and where. *)
and untold = { before : hypothesis; labels : Transition.label list }

(** A transition that is possible in a hypothesis. *)
type possible = { from : hypothesis; index : int; taken : Transition.t }

(** A state of the trace that does not fit a hypothesis. *)
type misfit = { of_ : hypothesis; differences : Against.difference list }

(** Where no hypothesis meets a further item. *)
type dead_end = {
  reached : hypothesis list;  (** all that were looked at since the last item was met *)
  possible : possible list;  (** events *)
  misfits : misfit list;
}

type outcome =
  | Met of { run : hypothesis; widest : int  (** hypotheses at once, at most *) }
  | Dead_end of dead_end
  | Unknown of { reason : reason; items : int  (** that were met *) }

and reason =
  | Too_many_states
  | Fault of Transition.fault  (** transitions that cannot be computed might have met it *)
  | Interrupted

val run :
  Against.t ->
  Recorded.t ->
  State.t ->
  observed:(Transition.label -> bool) ->
  limits ->
  (outcome, Transition.fault) result
(** From the declared state. [observed] tells which events have to be recorded. *)

val urgent : Transition.t -> bool
(** A collision or a strong split: no time passes while there is one. *)

val beyond : Against.t -> State.t -> Rat.t -> steps:int -> (State.t * Rat.t) list
(** The states from this one on, at this time, that are reached by the passing of time, and by lots, alone; at
    most so many, in the order of time. *)
