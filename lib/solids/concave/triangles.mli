(** The faces of a solid in triangles, for formats that have only triangles. *)

open Scc_geometry

val make : Polyhedron.ifs -> Polyhedron.ifs
(** [make set], for flat and simple faces, convex or not, replaces each face by triangles with a positive area.
    Their corners are those of the face, and all of them have its name. *)
