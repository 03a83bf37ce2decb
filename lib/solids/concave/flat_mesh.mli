(** Meshes without thickness, which no option makes a solid. *)

open Scc_geometry

val is_flat : Polyhedron.ifs -> bool
(** True if all corners of faces are in one plane or on one line, and there are corners. *)

val cure : string
(** What can be done about a sheet. *)

val advice : Polyhedron.ifs -> string option
(** A line on a mesh whose faces have all their corners in one plane, or on one line, and what can be done about
    it; [None] for all others, and for a mesh without faces. *)
