(** A run of a network without laws of motion, from event to event: what a step costs depends on those who take
    part in it and on their neighbours, and hardly on how many others there are. It offers and takes the same
    transitions as {!Network.successors}, in the same order, but does not write down whole states. *)

open Scc_exact
open Scc_calculus
open Scc_semantics

type t

val can_run : Model.t -> bool
(** Not with laws of motion, nor where processes bind that do not collide (reading I-33). *)

val start : Semantics.t -> State.t -> t
(** From any state of a model that {!can_run}. *)

(** A transition that is possible now. *)
type alternative = {
  label : Transition.label;
  rules : Rule.t list;
  rounded : Totals.t Lazy.t option;  (** [None]: nothing is rounded here *)
}

(** Alternatives are numbered from 0 on, as in {!Network.successors} of the present state: there may be thousands
    of them at one instant, and none is written down before it is asked for. The numbers hold until the next step.
    To ask for one that is not there is a bug. *)

val count : t -> int
val label : t -> int -> Transition.label
val alternative : t -> int -> alternative

val take : t -> int -> unit
(** Takes the alternative with a number. *)

val wait : t -> Rat.t -> alternative option
(** Takes {!Network.wait}. *)

val elapsed : t -> Rat.t
(** The time since the start. *)

val state : t -> State.t
(** The present state, in full: takes time proportional to its size. *)

val velocity : t -> int -> Vec.t
(** Of the process with this first leaf (a bug when there is none). *)

(** Who has changed: the first leaves of processes that are no more as they were, and the processes that came
    instead, as they are now, in order. A process that has only moved on is neither. *)
type changes = { gone : int list; come : State.process list }

val changes : t -> changes
(** Since it was asked for last, or since the start. *)

val work : t -> Flights.work
