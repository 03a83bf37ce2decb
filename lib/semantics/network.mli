(** The transition relation of networks (sections 3 and 4 of the rule book). *)

open Scc_calculus

val initial : Model.t -> State.t -> (State.t, Transition.fault) result
(** The initial state from the declared one: split clocks set, the first steer done. *)

val successors : Model.t -> State.t -> (Transition.t list, Transition.fault) result
(** Every transition of a state, in a fixed order. *)

val quiescent : Model.t -> State.t -> bool
(** No event can ever happen again (section 6). *)
