(** A model with its checks as it is seen from elsewhere: turned, moved, in other units, in a mirror. Each check
    asks of the image what it asks of the model: coordinates, velocities and momenta are written as those of the
    image. *)

open Scc_exact
open Scc_calculus
open Scc_property

type model = {
  model : Model.t;
  declared : State.t;
  uncertain : Uncertain.t option;  (** {!Scc_elaborate.Elaborate.t} *)
  checks : Property.check list;
}

type t = {
  name : string;
  time : Rat.t;  (** what a time of 1 becomes *)
  right : bool;  (** it takes axes to axes *)
  see : model -> model;
}

val of_elaborated : Scc_elaborate.Elaborate.t -> model

val rotations : t list
(** The 24 of a cube. *)

val rotation : Quaternion.t -> t
val displacement : Vec.t -> t
val units : length:Rat.t -> time:Rat.t -> mass:Rat.t -> t

val mirror : t
(** x becomes -x: for translational models. *)

val any : t QCheck2.Gen.t
(** At random, also by rotations by any angle. *)
