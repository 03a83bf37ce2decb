(** STL files, ASCII and binary. They have triangles only, without shared vertices. Equal points become one
    vertex, triangles with two equal corners are dropped, and {!Merge_coplanar} makes maximal faces. Normals
    and attributes are not used: the order of the corners orients a triangle. All of an ASCII file may be
    on one line. *)

open Scc_base
open Scc_geometry

val read : path:string -> string -> (Polyhedron.ifs * Diag.t list, Diag.t) result
(** [read ~path text] is the set of faces of a file. Bytes after the last triangle are a warning (SC0324), unless
    they are the data that triangles announce in their last number. Errors (SC0320) are located in the file. *)
