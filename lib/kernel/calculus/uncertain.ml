(** What of a declared network depends on parameters that have ranges ({!Model.ranges}), as affine forms over
    them. *)

open Scc_polyhedra

type place = Linear.t * Linear.t * Linear.t
(** Coordinates. *)

type glue = { leaf : int; one : Site.t; two : Site.t }
(** Features of two parts of a leaf which are glued, where the parts are not at a known place from each other. *)

type t = {
  places : place array;  (** by leaf: of its reference point, in the world, as declared *)
  glues : glue list;
}
