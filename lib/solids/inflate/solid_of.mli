(** The inflated shape as a solid: its front, and its mirror image behind, joined along the outline. The solid
    is closed, and does not meet itself. Each side is a graph over the inside of the outline, one above 0 and
    the other one below. *)

open Scc_exact
open Scc_geometry

(** The errors of the solid, all in pixels. *)
type gaps = {
  solution : Rat.t;  (** the heights over the centres of pixels, before simplification, from the exact ones *)
  surface : Rat.t;  (** the simplified front from the one over all pixels, upward or downward, anywhere *)
  outline : Rat.t;  (** the simplified outline from that around all pixels *)
}

type t = {
  mesh : Polyhedron.ifs;
  (** The middle of the picture is the origin. The x axis goes to its right, the y axis to its top, and the z
      axis towards the viewer. Faces are triangles, counter-clockwise from outside, those of the front
      first. *)
  holes : int;
  gaps : gaps;
}

val everything : Relief.t -> int
(** The number of faces of the solid without simplification. *)

val make :
  progress:(float -> unit) -> faces:int option -> scale:Rat.t -> Relief.t -> (t, int) result
(** [make ~progress ~faces ~scale r] is the solid with at most [faces] faces, or without simplification if that
    is [None]. Lengths of the mesh are multiplied by [scale] > 0; those of {!type-gaps} are not. The error is the
    number of faces that would be needed. *)

val together : t list -> t
(** [together solids] are solids that do not meet, as one of several closed surfaces, with the sum of the holes
    and the greatest of each of the errors. *)
