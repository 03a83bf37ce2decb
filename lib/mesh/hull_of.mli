(** The convex hull of the vertices of a file. *)

open Scc_geometry

val hull : Polyhedron.ifs -> Polyhedron.ifs option
(** Its faces are maximal, and named [f0], [f1], …; vertices keep their names, but those that are no corners go.
    [None] when all vertices are in one plane. *)
