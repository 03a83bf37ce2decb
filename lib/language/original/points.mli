(** Polyhedra told as sets of points, [polyhedron(p, q, …)], with their regions: which of these are vertices and
    faces. *)

open Scc_syntax

type t = {
  faces : (Ast.name * Ast.vector) list * (Ast.name * Ast.name list) list;  (** as the language has templates *)
  others : (Ast.name * Region.t) list;  (** the regions that are no vertices or faces *)
}

val read : Plain.t -> at:Scc_base.Span.t -> Ast.vector list -> (Ast.name * Region.t) list -> t
(** The points, and the regions declared on the shape. A region [point(p)] of a corner names that vertex, and a
    [polygon] of all corners of a face that face. Where all coordinates are plain numbers the solid is the
    convex hull of the points; points that are no corners of it, and corners without a name, may be among them:
    those are left out, and these called v1, v2, …, as faces without a name are f1, f2, …. Else (where
    parameters are in them) points are compared as they are written, all of them are corners, and the polygons
    of listed points are all the faces: what comes of it is checked when its numbers are known.

    Raises {!Fault.Found}: SC0301 where all points are in one plane. *)
