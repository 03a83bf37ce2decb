(** OBJ files (Wavefront): the statements [v] and [f] (with [/vt] and [/vn], and with negative, relative
    indices). Groups ([g]) and objects ([o]), where there are no groups, name faces
    ({!Face_names}). Materials, normals, texture coordinates, lines and points are skipped: they
    bound nothing. Several objects of one file make one set of faces. *)

open Scc_base
open Scc_geometry

val read : path:string -> string -> (Polyhedron.ifs, Diag.t) result
