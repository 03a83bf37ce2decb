(** A plain bounded exploration, apart from the explorer that it helps to test. *)

open Scc_calculus
open Scc_semantics

val states : Model.t -> State.t -> limit:int -> (State.t * Transition.t list) list
(** The first [limit] states found breadth first from a state, each with all its transitions, in order of
    discovery. Fails when a law of motion cannot be evaluated. *)

val initial : Model.t -> State.t -> State.t
(** The initial state of a declared one. *)

val successors : Model.t -> State.t -> Transition.t list

val follow : Semantics.t -> State.t -> int list -> (Transition.t list, int) result
(** The transitions that a list of choices, indices into the successors, leads through; or the place in the list of
    the one that does not fit. *)
