(** States of a model by the choices that lead to them. *)

open Scc_exact
open Scc_calculus
open Scc_semantics

type t
(** A model with its initial state, and states that were asked for lately, which only save time. *)

type place = {
  path : int array;
  state : State.t;
  time : Rat.t;  (** model time *)
  last : (State.t * Transition.label) option;  (** how it was reached: none for the initial state *)
}

val make : Semantics.t -> initial:State.t -> t

val semantics : t -> Semantics.t
val model : t -> Model.t
val initial : t -> State.t

val follow : t -> int array -> place
(** Refuses a path that is not possible ([Not_possible]), or on which transitions cannot be computed
    ([No_transitions]). *)

val along : t -> int array -> (place -> Transition.label option -> 'a) -> 'a list
(** Of each place on a path, the initial one first, and what happens there next on the path: nothing at its end.
    Refuses as {!follow}. *)

val labels : Model.t -> Transition.t list -> string list
(** Their texts. *)

val next : t -> place -> Transition.t list
(** Its transitions, in order. *)
