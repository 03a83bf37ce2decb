(** Symmetries of the semantics: maps of models and states that must commute with [successors]. *)

open Scc_exact
open Scc_calculus

type t = {
  name : string;
  model : Model.t -> Model.t;
  state : State.t -> State.t;
  bond : State.bond -> State.bond;
  leaf : int -> int;
}

val translation : Vec.t -> t
(** The whole network elsewhere. *)

val rotation : string -> Mat.t -> t
(** The whole network turned by a rotation of a cube, its shapes as they are declared. Laws of motion are not
    turned: for inertial models. *)

val turning : Quaternion.t -> t
(** The whole network turned, by the orientations of its leaves: for rigid inertial models that do not round. *)

val rotations : t list
(** The 24 rotations of a cube. *)

val permutation : int array -> t
(** The leaves declared in another order: leaf [i] becomes leaf [perm.(i)]. *)

val broken : t -> Model.t -> (State.t * Scc_semantics.Transition.t list) list -> string option
(** Whether the symmetry fails to commute with the transitions at some of these states of the model: labels,
    rules and targets are compared as multisets. *)
