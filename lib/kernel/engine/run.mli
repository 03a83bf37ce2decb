(** One run of a network: what can happen next, and one of it happens.

    A network without laws of motion runs from event to event ({!Event_run}): a step costs about as much as the few
    bodies that take part in it, and only {!state} looks at all. Under laws of motion every step changes the
    velocity of every steered body anyway, and the whole of {!Network.successors} is computed for each; so
    it is where processes bind that do not collide (reading I-33). Draws are no steps of that kind: all bodies that
    draw at one instant are asked in turn, each for itself, and the last one takes the network on. *)

open Scc_calculus
open Scc_semantics

type t

val start : Semantics.t -> State.t -> (t, Transition.fault) result
(** At the initial state, from the declared one. *)

val resume : Semantics.t -> State.t -> t
(** At any state of a model, such as the initial one. *)

type alternative = Event_run.alternative = {
  label : Transition.label;
  rules : Rule.t list;
  rounded : Totals.t Lazy.t option;  (** what rule Round added to the totals of the network, if it was used *)
}

(** What may happen: so many transitions, and the label of each by its number, from 0. It holds until the next
    step. *)
type labels = { count : int; label : int -> Transition.label }

val labels : t -> (labels, Transition.fault) result
(** Those of {!Network.successors} of the present state, in that order. *)

val list : labels -> Transition.label list

val take : t -> int -> alternative
(** Takes the one with a number, from 0 (a bug when there is none, or a fault), and says what was taken. *)

val wait : t -> Scc_exact.Rat.t -> (alternative option, Transition.fault) result
(** Takes {!Network.wait}, and says what was taken. *)

val elapsed : t -> Scc_exact.Rat.t
(** The time since it began. *)

val state : t -> State.t
(** The present state, in full. *)

val changes : t -> Event_run.changes option
(** Who has changed since it was asked for last, or since the start, of a network that runs from event to event; of
    another one only its states tell. *)

val quiescent : t -> bool
(** {!Network.quiescent} of the present state, in which nothing is possible (of no meaning otherwise). *)

val spinning : t -> bool
(** Whether something spins now. *)

val rounded : t -> (Totals.t * Totals.t) option
(** Bounds on what rule Round has added to the totals of the network so far, closely; [None] where nothing is
    rounded. *)
