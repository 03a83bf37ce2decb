(** Polyhedra given by their points, [polyhedron(p, q, …)], and those of their regions that are vertices and
    faces. *)

open Scc_syntax

type t = {
  faces : (Ast.name * Ast.vector) list * (Ast.name * Ast.name list) list;
  (** vertices and faces of a template of the language *)
  others : (Ast.name * Region.t) list;  (** the regions that are no vertices or faces *)
}

val read : Plain.t -> at:Scc_base.Span.t -> Ast.vector list -> (Ast.name * Region.t) list -> t
(** [read plain ~at points regions] finds the vertices and faces of a polyhedron among its points and the
    regions declared on it. A region [point(p)] at a corner names that vertex, and a [polygon] of all corners of
    a face names that face.

    If all coordinates are plain numbers, the solid is the convex hull of the points. Points that are no corners
    are left out. Corners without a name are called v1, v2, …, and faces without a name f1, f2, ….

    Otherwise (with parameters in them) points are compared as they are written. All of them are corners, and
    the polygons of listed points are all the faces. The result is checked when its numbers are known.

    Raises {!Fault.Found}: SC0301 if all points are in one plane. *)
