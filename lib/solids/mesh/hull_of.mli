(** The convex hull of the vertices of a file. *)

open Scc_geometry

val hull : Polyhedron.ifs -> Polyhedron.ifs option
(** Its faces are maximal, and named [f0], [f1], …; vertices keep their names, but those that are no corners go.
    [None] when all vertices are in one plane. *)

val flattened : within:float -> Polyhedron.ifs -> Polyhedron.ifs
(** Of such a hull: neighbouring faces that are flat within the distance are one ({!Nearly_flat}), and vertices
    that are not on three faces any more go. Faces are [f0], [f1], … again. What comes out need not be flat. *)

val named : (string * Scc_exact.Vec.t) list -> Polyhedron.ifs option
(** The hull of points, as the language has it: its faces are f1, f2, … in the order of the first three of their
    corners, without numbers that a point has. *)
