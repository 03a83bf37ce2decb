(** The faces of a solid in triangles, for formats that have nothing else. *)

open Scc_geometry

val make : Polyhedron.ifs -> Polyhedron.ifs
(** Of flat and simple faces, convex or not: each in triangles with an area, between its own corners, all of them
    under its name. *)
