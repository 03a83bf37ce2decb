(** The convex hull of the vertices of a file. *)

open Scc_geometry

val hull : Polyhedron.ifs -> Polyhedron.ifs option
(** The convex hull of the vertices. Its faces are maximal, and named [f0], [f1], …. Vertices keep their names;
    those that are no corners are dropped. [None] if all vertices are in one plane. *)

val in_order : Polyhedron.ifs -> Polyhedron.ifs
(** Faces of a convex solid in the order and under the names of {!hull}, each from its least corner on. The order
    of corners stays. *)

val flattened : within:float -> Polyhedron.ifs -> Polyhedron.ifs
(** [flattened ~within hull] unites neighbouring faces of a {!hull} that are flat within the distance
    ({!Nearly_flat}). Vertices that are on fewer than three faces then are dropped. Faces are named [f0], [f1],
    … again. The new faces need not be flat. *)

val named : (string * Scc_exact.Vec.t) list -> Polyhedron.ifs option
(** The hull of named points, as in the language. Its faces are f1, f2, … in the order of the first three of
    their corners, without names that a point has. [None] if all points are in one plane. *)
