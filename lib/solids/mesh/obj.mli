(** OBJ files (Wavefront): the statements [v] and [f] (with [/vt] and [/vn], and with negative, relative
    indices). Faces are named by groups ([g]), or by objects ([o]) where there are no groups ({!Face_names}).
    Materials, normals, texture coordinates, lines and points are skipped. Several objects of one file make one
    set of faces. *)

open Scc_base
open Scc_geometry

val read : path:string -> string -> (Polyhedron.ifs, Diag.t) result
(** [read ~path text] is the set of faces of a file. Errors (SC0320) are located in the file. *)
