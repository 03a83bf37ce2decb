(** A solid in the world: turned, then moved. World frame. *)

open Scc_exact
open Scc_geometry

type t = {
  solid : Solid.t;
  turned : Quaternion.t;
  at : Vec.t;  (** of the reference point *)
}

val point : t -> Vec.t -> Vec.t
(** [point b p] is the place of the point of the solid that is at [p] relative to its reference point before
    any turn. *)

val vertices : t -> Vec.t array
(** The places of all vertices, in the world. *)

val integers : t -> Ivec.t array * Z.t
(** The places of the vertices over one denominator, which is positive but need not be the least. *)

val over_one : t -> t -> Ivec.t array * Ivec.t array * Z.t
(** The places of the vertices of both over one positive denominator. *)

val corners : t -> Feature.t -> Vec.t list
(** The places of the vertices of a feature; those of a face in its order. *)

val centroid : t -> Vec.t
(** The place of the centroid of the uniform solid, in the world. *)

val fixed_solid : t -> Solid.t
(** The solid, turned ({!Scc_geometry.Solid.turned}). Together with {!field-at} it is an argument of the queries of
    {!Scc_geometry}. Not cheap, unless the solid is not turned: then it is the solid itself. *)
