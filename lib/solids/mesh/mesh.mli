(** Readers of polyhedron files. Coordinates are read exactly: decimals as written, binary floating-point
    numbers as the dyadic rationals that they are. *)

open Scc_base
open Scc_geometry

val formats : (string * string) list
(** The endings of names that are known, each with the name of the format. *)

val read : path:string -> string -> (Polyhedron.ifs, Diag.t) result
(** [read ~path text]: the format is found from the name's ending ([.off], [.obj], …) and, when that is not
    known, from how the text begins. Vertices are named [v0, v1, …] and faces [f0, f1, …] in the order of
    the file. Faces are as the file has them, except those of an STL file, which knows triangles only:
    there equal points are made one vertex and {!Merge_coplanar} makes maximal faces. Errors (SC0320,
    SC0321) are located in the file; time and memory are near linear in its size, whatever its header says (a set
    of fractions without a common denominator of bearable length is SC0106). *)
