(** States of a model, by the choices that lead to them. *)

open Scc_exact
open Scc_calculus
open Scc_semantics

type t
(** A model with its initial state and a cache of states. *)

(** A state at the end of a path. *)
type place = {
  path : int array;
  state : State.t;
  time : Rat.t;  (** model time *)
  last : (State.t * Transition.label) option;  (** the last transition and its source; [None] at first *)
}

val make : Semantics.t -> initial:State.t -> t
(** A model with an empty cache. *)

val semantics : t -> Semantics.t
(** The semantics of the model. *)

val model : t -> Model.t
(** The model. *)

val follow : t -> int array -> place
(** The end of a path. A choice that is not possible is refused ([Not_possible]), and so is a state whose
    transitions cannot be computed ([No_transitions]). *)

val along : t -> int array -> (place -> Transition.label option -> 'a) -> 'a list
(** [along t path f] is [f] of each place on the path, the initial one first, and of the label that follows
    there, if any. It refuses paths as {!follow} does. *)

val labels : Model.t -> Transition.t list -> string list
(** The texts of the labels of transitions. *)

val next : t -> place -> Transition.t list
(** The transitions of a place, in order. *)
