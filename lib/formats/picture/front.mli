(** The part of a convex polyhedron that is in front of an eye. *)

open Scc_exact

(** Corners, faces and edges of a polyhedron. *)
type mesh = {
  corners : Ivec.t array;  (** over [denominator] *)
  denominator : Z.t;  (** positive *)
  faces : int array array;
  (** counterclockwise seen from outside. A face that is cut off has no corners; the others keep their numbers *)
  edges : (int * int) array;  (** an edge that is cut off has the same corner twice *)
}

val part : height:(Ivec.t -> Z.t) -> mesh -> mesh option
(** [part ~height mesh] is the part of a convex polyhedron where [height], a linear function of numerators of
    corners, is not negative. The cut itself is no face. [None] if that part has no volume. *)
