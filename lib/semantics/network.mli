(** The transition relation of networks (rule Successors). *)

open Scc_calculus

val initial : Model.t -> State.t -> (State.t, Transition.fault) result
(** The initial state from the declared one: split clocks set, the first steer done. *)

val successors : Model.t -> State.t -> (Transition.t list, Transition.fault) result
(** Every transition of a state, in a fixed order: strong splits, weak splits, each collision of the instant
    by itself (reading I-8), and time. A steer that falls due is part of the transition (reading I-15). *)

(** What may happen at an instant, without time passing. *)
type instant = {
  discrete : Transition.t list;  (** in the order of {!successors} *)
  urgent : bool;  (** a strong split or a collision: time may not pass *)
}

val instant : Model.t -> State.t -> (instant, Transition.fault) result
(** Splits look at one process, and a collision at two (unless the model is steered): so for some processes of
    a state taken by themselves, the answer is what the whole state gives for them, in the same order. *)

val time_rules : Rule.t list
(** Those that a passing of time uses. *)

val quiescent : Model.t -> State.t -> bool
(** No event can ever happen again (rule Quiescent). *)
