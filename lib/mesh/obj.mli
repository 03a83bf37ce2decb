(** OBJ files (Wavefront): the statements [v] and [f] (with [/vt] and [/vn], and with negative, relative
    indices). Groups, objects, materials, normals, texture coordinates, lines and points are skipped: they
    bound nothing. Several objects of one file make one set of faces. *)

open Scc_base
open Scc_geometry

val read : path:string -> string -> (Polyhedron.ifs, Diag.t) result
