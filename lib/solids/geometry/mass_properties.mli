(** Volume, centroid and inertia of the uniform solid that a closed surface bounds (Definition 4.4, rule
    Mass). Exact: sums over the signed tetrahedra that the origin spans with the triangles of the faces.
*)

open Scc_exact

type t = {
  volume : Rat.t;  (** positive for a solid oriented outward *)
  centroid : Vec.t;  (** in the frame of the points *)
  inertia : Mat.t;  (** about the centroid, along the axes of the frame, for unit density *)
}

val of_surface : Ivec.t array -> Z.t -> int array array -> t
(** [of_surface points denominator faces] are the properties of the uniform solid with the vertices [points /
    denominator]. The faces are planar and form a closed surface whose volume is not zero (a bug otherwise). *)

val of_polyhedron : Polyhedron.t -> t
(** The mass properties of a polyhedron, in body space. *)

val inertia : mass:Rat.t -> t -> Mat.t
(** [inertia ~mass t] is the inertia tensor about the centroid of the uniform solid of that mass, along the
    axes of the frame. *)
