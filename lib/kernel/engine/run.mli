(** One run of a network, step by step: the transitions that are possible next, and the one that is taken.

    A model that {!Event_run.can_run} runs from event to event. The cost of a step depends on the few bodies that
    take part in it, and only {!state} visits all bodies. In other models, all of [Network.successors] is
    computed for each step. These have laws of motion with variables, steps of single processes or turns, or bind
    bodies that do not collide (reading I-33).

    Draws are handled one body at a time: the bodies that draw at one instant do so in turn. The draw of the last
    of them computes the next velocities of all. *)

open Scc_calculus
open Scc_semantics

type t

val start : Semantics.t -> State.t -> (t, Transition.fault) result
(** [start c declared] is a run at the initial state that follows from the declared state ([Network.initial]). *)

val resume : Semantics.t -> State.t -> t
(** [resume c s] is a run at [s], which may be any state of the model, such as the initial one. *)

type alternative = Event_run.alternative = {
  label : Transition.label;
  rules : Rule.t list;
  rounded : Totals.t Lazy.t option;  (** what rule Round added to the totals of the network, if it was used *)
  replaced : (State.process list * State.process list) option;
  (** the processes that it replaced, and those that came ({!Event_run.alternative}); [None]: compare the states *)
}

(** The possible transitions: their number, and the label of each by its number, from 0. The record is valid
    until the next step. *)
type labels = {
  count : int;
  label : int -> Transition.label;
  chance : int -> Scc_exact.Rat.t;  (** {!Scc_semantics.Transition.chance} of the label *)
  tie : Ties.tie option;  (** what chance decides between urgent transitions, if it does (rule Ties) *)
}

val labels : t -> (labels, Transition.fault) result
(** The labels of {!Scc_semantics.Network.successors} of the present state, in that order. *)

val list : labels -> Transition.label list
(** All labels as a list, in order. *)

val take : t -> int -> alternative
(** Takes the transition with a number, from 0, and returns it. It is a bug if there is no such transition, or if
    {!val-labels} is a fault. *)

val wait : t -> Scc_exact.Rat.t -> (alternative option, Transition.fault) result
(** [wait t d] takes the transition [Network.wait] by [d] and returns it; [None] if there is none. *)

val elapsed : t -> Scc_exact.Rat.t
(** The time since the start of the run. *)

val draws_on : t -> bool
(** [draws_on t] is true if a velocity or a lot is drawn next. If a draw or a lot was just taken, then nothing has
    changed but what is drawn (rule JoinedDraws). *)

val state : t -> State.t
(** The present state, in full. It takes time proportional to the size of the network. *)

val part : t -> int list -> State.t
(** [part t leaves] is {!state} without the processes that have none of these leaves. From event to event, its time
    does not depend on the size of the network. *)

val eventwise : Model.t -> bool
(** [eventwise m] is true if [m] runs from event to event. Its runs have {!changes}, unless laws turn out to have
    no value. Between two movement steps the changes are few; at a movement step all bodies may change. *)

val inertial : Model.t -> bool
(** [inertial m] is true if [m] runs from event to event and has no laws of motion. Its runs have {!changes}, which
    are few in each step. *)

val changes : t -> Event_run.changes option
(** The changes since the last call of this function, or since the start of the run ({!Event_run.val-changes}). The
    result is [None] in a run that does not go from event to event; there, compare its states. *)

val quiescent : t -> bool
(** [quiescent t] is [Network.quiescent] of the present state. It is valid only if no transition is possible. *)

val spinning : t -> bool
(** [spinning t] is true if the spin of some process is not 0 now. *)

val rounded : t -> (Totals.t * Totals.t) option
(** Lower and upper bounds on what rule Round has added to the totals of the network so far ({!Totals.bounds});
    [None] if the model rounds nothing. *)
