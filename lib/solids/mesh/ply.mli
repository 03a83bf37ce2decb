(** PLY files (Stanford), ASCII and binary of either byte order: the properties [x], [y], [z] of the element
    [vertex] and the list [vertex_indices] (or [vertex_index]) of the element [face], or of [tristrips], whose
    strips end with -1. Other properties are skipped. *)

open Scc_base
open Scc_geometry

val read : path:string -> string -> (Polyhedron.ifs * Diag.t list, Diag.t) result
(** [read ~path text] is the set of faces of a file, with warnings (SC0324) of other elements and of bytes after
    the last one. Errors (SC0320) are located in the file. *)
