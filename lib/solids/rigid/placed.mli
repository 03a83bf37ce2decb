(** A solid where it stands: turned, then moved. World frame. *)

open Scc_exact
open Scc_geometry

type t = {
  solid : Solid.t;
  turned : Quaternion.t;
  at : Vec.t;  (** of the reference point *)
}

val of_motion : Motion.t -> Rat.t -> t
(** Where a moving solid is at a time. *)

val point : t -> Vec.t -> Vec.t
(** Where the point of the solid is that is at a vector from its reference point before any turn. *)

val vertices : t -> Vec.t array
val integers : t -> Ivec.t array * Z.t
(** The vertices over one denominator, which is positive but need not be the least. *)

val over_one : t -> t -> Ivec.t array * Ivec.t array * Z.t
(** The vertices of both over one denominator. *)

val corners : t -> Feature.t -> Vec.t list

val centroid : t -> Vec.t

val fixed_solid : t -> Solid.t
(** The solid, turned: with {!field-at} as its place, what the queries of {!Scc_geometry} take. Not cheap, unless
    it is not turned. *)
