(** STL files, ASCII and binary. Triangles only, without shared vertices: equal points are made one vertex,
    triangles with two equal corners (which enclose nothing) are left out, and {!Merge_coplanar} makes
    maximal faces. Normals and attributes are not used: the order of the corners orients a triangle. *)

open Scc_base
open Scc_geometry

val read : path:string -> string -> (Polyhedron.ifs, Diag.t) result
