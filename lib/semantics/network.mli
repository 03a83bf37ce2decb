(** The transition relation of networks (rule Successors). *)

open Scc_calculus

val initial : Model.t -> State.t -> (State.t, Transition.fault) result
(** The initial state from the declared one: split clocks set, the first steer done. *)

val successors : Model.t -> State.t -> (Transition.t list, Transition.fault) result
(** Every transition of a state, in a fixed order: strong splits, weak splits, each collision of the instant
    by itself (reading I-8), and time. A steer that falls due is part of the transition (reading I-15). *)

val quiescent : Model.t -> State.t -> bool
(** No event can ever happen again (rule Quiescent). *)
