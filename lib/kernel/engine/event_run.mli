(** A run of a network from event to event. The cost of a step depends on the processes that take part in it and on
    their neighbours, and hardly on the size of the network. Laws of motion are evaluated for all bodies at once,
    at the end of each movement step. A run has the same transitions as
    {!Scc_semantics.Network.successors}, in the same order, but does not build whole states. *)

open Scc_exact
open Scc_calculus
open Scc_semantics

type t

val can_run : Model.t -> bool
(** [can_run m] is true if [m] has no turns, and its processes bind only if they collide (reading I-33). If [m] has
    laws of motion, each of them never fails ([Law.never_fails]), and processes have no movement steps of their
    own. *)

val start : Semantics.t -> State.t -> t
(** A run from any state of a model that {!can_run}. Any other model is a bug. *)

val semantics : t -> Semantics.t
(** The semantics of a run, without caches of processes. *)

val may_fail : t -> bool
(** [may_fail t] is true in two cases. Laws of a process that is there, or that the next transition may make, have
    no value: [Law.Too_many]. Or the chances of the next lot sum to more than 1. Then the rules have to decide what
    happens next, from {!state} on. *)

(** A transition that has been taken. *)
type alternative = {
  label : Transition.label;
  rules : Rule.t list;
  rounded : Totals.t Lazy.t option;  (** [None] in these runs: nothing is rounded *)
  replaced : (State.process list * State.process list) option;
  (** the processes that it replaced by others, as they were, and these others; all processes that gained or lost
      leaves or bonds are among them. [None], in no such run: compare the states *)
}

(** Alternatives are numbered from 0 on, as in [Network.successors] of the present state. There may be thousands
    of them at one instant, and each is built when it is used. The numbers are valid until the next step. A
    number out of range is a bug. *)

val count : t -> int
(** The number of alternatives in the present state. *)

val label : t -> int -> Transition.label
(** The label of the alternative with a number. *)

val chance : t -> int -> Rat.t
(** [chance t i] is [Transition.chance (label t i)]. *)

val tie : t -> Ties.tie option
(** What chance decides between urgent transitions now, if it does (rule Ties). *)

val take : t -> int -> alternative
(** Takes the alternative with a number and returns it. *)

val wait : t -> Rat.t -> alternative option
(** [wait t d] takes the transition [Network.wait] by [d] and returns it; [None] if there is none. *)

val elapsed : t -> Rat.t
(** The time since the start of the run. *)

val draws_on : t -> bool
(** [draws_on t] is true if a velocity or a lot is drawn next ({!Run.draws_on}). *)

val state : t -> State.t
(** The present state, in full. It takes time proportional to the size of the network. *)

val part : t -> int list -> State.t
(** [part t leaves] is {!state} without the processes that have none of these leaves. Its time does not depend on
    the size of the network. *)

val velocity : t -> int -> Vec.t
(** The velocity of the process with this first leaf, in the world. It is a bug if no process begins with the
    leaf. *)

(** Changes of processes. [gone] is the first leaves of the processes that are no more as they were. [come] is
    the processes that replace them, as they are now. Both are in order. A process that has only moved is in
    neither. *)
type changes = { gone : int list; come : State.process list }

val changes : t -> changes
(** The changes since the last call of this function, or since the start of the run. *)

val work : t -> Flights.work
(** The work of the broad phase since the start of the run. *)
