(** Symmetries of the semantics: maps of models and states that must commute with [successors]. *)

open Scc_exact
open Scc_calculus

type t = {
  name : string;
  model : Model.t -> Model.t;
  state : State.t -> State.t;
  later : Rat.t -> State.t -> State.t;  (** of the target of a transition that lasts so long *)
  duration : Rat.t -> Rat.t;
  impulse : Rat.t -> Rat.t;  (** of a push *)
  velocity : Vec.t -> Vec.t;  (** that is drawn *)
  bond : State.bond -> State.bond;
  leaf : int -> int;
}

val make :
  string -> ?model:(Model.t -> Model.t) -> ?later:(Rat.t -> State.t -> State.t) -> ?duration:(Rat.t -> Rat.t) ->
  ?impulse:(Rat.t -> Rat.t) -> ?velocity:(Vec.t -> Vec.t) ->
  ?bond:(State.bond -> State.bond) -> ?leaf:(int -> int) -> (State.t -> State.t) -> t
(** Of what is not said, the identity; [later] is [state] whatever has passed. *)

val mapped_lots :
  ?time:(Rat.t -> Rat.t) -> ?bond:(State.bond -> State.bond) -> ?leaf:(int -> int) ->
  ?summand:(Behaviour.t -> Behaviour.t) -> State.lots -> State.lots
(** Lots with other times, bonds, leaves and summands. *)

val translation : Vec.t -> t
(** The whole network elsewhere. *)

val rotation : string -> Mat.t -> t
(** The whole network turned by a rotation of a cube, its shapes as they are declared. Laws of motion are not
    turned: for inertial models. *)

val any_rotation : Quaternion.t -> t
(** The same by any rotation. *)

val boost : Vec.t -> t
(** The whole network seen from what moves on in a straight line: for models in which nothing is fixed. *)

val scaling : length:Rat.t -> time:Rat.t -> mass:Rat.t -> t
(** Other units of length, time and mass. Laws of motion are left as they are: for inertial models. *)

val turning : Quaternion.t -> t
(** The whole network turned, by the orientations of its leaves: for rigid inertial models that do not round. *)

val rotations : t list
(** The 24 rotations of a cube. *)

val permutation : int array -> t
(** The leaves declared in another order: leaf [i] becomes leaf [perm.(i)]. *)

val broken : t -> Model.t -> (State.t * Scc_semantics.Transition.t list) list -> string option
(** Whether the symmetry fails to commute with the transitions at some of these states of the model: labels,
    rules and targets are compared as multisets. *)
