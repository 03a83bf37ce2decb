(** The transition relation of networks (rule Successors). *)

open Scc_calculus

val initial : Semantics.t -> State.t -> (State.t, Transition.fault) result
(** [initial c declared] is the initial state: split clocks set, laws evaluated for the first time where there are
    laws, first turns begun. *)

val started : Semantics.t -> State.t -> State.t
(** [started c declared] is the initial state before laws are evaluated for the first time: {!initial} is what
    {!Steer.settle} makes of it. *)

val successors : Semantics.t -> State.t -> (Transition.t list, Transition.fault) result
(** Every transition of a state, in a fixed order. While lots are pending, these are the outcomes of the next lot
    (rule Lot). Else, while a process waits to draw, they are the draws of the next process (rule Draw). Else
    they are strong splits and closings, weak splits, each collision of the instant by itself (reading I-8), and
    time. An evaluation of laws that falls due is part of the transition (reading I-15). *)

val wait : Semantics.t -> State.t -> Scc_exact.Rat.t -> (Transition.t option, Transition.fault) result
(** [wait c s d] is rule Time by d, in models whose bonds may be released at any time ([Model.Any_time]). Valid
    are 0 < d < {!Time.delay}, or any d > 0 if that is [None]; {!successors} has only the greatest d. The result
    is [None] for any other d, in other models, and while something urgent or drawn comes first. *)

val quiescent : Semantics.t -> State.t -> bool
(** [quiescent c s] is true if no event can ever happen again (rule Quiescent). *)

(** {1 In parts}

    A split and a closing depend on one process, and a collision depends on two. So the discrete transitions of a
    network are those of each process and of each two that meet. A caller that follows many states of a network
    that is not steered may cache these parts, and put them together with the functions below. *)

(** The discrete transitions of a state, by kinds. Each list has the last element first: single processes in the
    order of processes, collisions in the order of pairs. *)
type 'a discrete = { urgent : 'a list; weak : 'a list; collisions : 'a list }

val is_urgent : 'a discrete -> bool
(** [is_urgent d] is true if no time passes before an event: there are urgent transitions or collisions. *)

val in_order : ('a -> 'b) -> 'a discrete -> time:(unit -> 'b list) -> 'b list
(** [in_order f d ~time] is the image of [d] under [f] in the order of {!successors}, and then [time ()]. If
    something is urgent, [time] is not called. *)

val urgent : Semantics.t -> State.process -> Transition.outcome list
(** What a process must do by itself: its strong splits ({!Splits.strong}), then its closings ({!Closings.all}).
    Outcomes with equal label and result are one. *)

val weak : Semantics.t -> State.process -> Transition.outcome list
(** What a process may do by itself: its weak splits ({!Splits.weak}). Outcomes with equal label and result are
    one. *)

val together : Semantics.t -> State.process array -> Transition.outcome list
(** The outcomes of all collisions among some processes, in the order of {!Collisions.clusters}; for networks
    that are not steered. The collision of two processes has the same outcomes in any company, unless collisions
    are resolved together. A persistent contact is a bug. *)

val after_collision : Model.t -> State.step option -> State.step option
(** The movement step of the network after a collision, which ends it (rule Steer). A step stays as it is if this
    instant has been steered already, or if steps keep their beat ({!Model.keeps_beat}). *)

val drawn :
  Semantics.t -> State.t -> before:(State.process -> Given.t option) -> State.process ->
  Given.t * Scc_exact.Rat.t -> (Transition.t, Transition.fault) result
(** [drawn c s ~before p (given, chance)] is the transition in which [p] draws the motion [given], one of
    {!Steer.chances}. [before] is the motions that other processes of [s] have drawn earlier, each in its turn
    ({!Steer.drawers}). *)

val draw_rules : Rule.t list
(** The rules that a draw uses if another process still waits: Draw alone. *)

val time_rules : Semantics.t -> Rule.t list
(** The rules that a passing of time uses: Time and TimeBehaviour, and Turn where bodies turn. *)
