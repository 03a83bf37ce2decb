(** The transition relation of networks (rule Successors). *)

open Scc_calculus

val initial : Model.t -> State.t -> (State.t, Transition.fault) result
(** The initial state from the declared one: split clocks set, the first steer done. *)

val successors : Model.t -> State.t -> (Transition.t list, Transition.fault) result
(** Every transition of a state, in a fixed order: strong splits, weak splits, each collision of the instant
    by itself (reading I-8), and time. A steer that falls due is part of the transition (reading I-15). *)

(** {1 Kinds of transitions}

    A split looks at one process, and a collision at two (unless the model is steered). So what is possible in a
    state is what is possible for each process, and each two, taken by themselves; in the order of
    {!successors}: strong splits by process, weak splits by process, collisions by pair. *)

val strong : Model.t -> State.t -> (Transition.t list, Transition.fault) result
val weak : Model.t -> State.t -> (Transition.t list, Transition.fault) result
val collisions : Model.t -> State.t -> (Transition.t list, Transition.fault) result

val colliding : Model.t -> State.t -> (int * int) list
(** The pairs of processes that collide, by their indices, sorted. *)

val time_rules : Model.t -> Rule.t list
(** Those that a passing of time uses. It is possible when no strong split and no collision is. *)

val quiescent : Model.t -> State.t -> bool
(** No event can ever happen again (rule Quiescent). *)

val follow :
  Model.t -> State.t -> int list -> (Transition.t list, int * Transition.fault option) result
(** The transitions that a list of choices, indices into {!successors}, leads through; or the place in the list of
    the one that does not fit, with the fault if the state's transitions could not be computed. *)
