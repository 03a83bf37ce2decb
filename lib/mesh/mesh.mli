(** Readers of polyhedron files. Coordinates are read exactly, as decimals. *)

open Scc_base
open Scc_geometry

val read : path:string -> string -> (Polyhedron.ifs, Diag.t) result
(** [read ~path text]: the format is found from the name's ending ([.off], [.obj], …) and, where there can
    be doubt, the text. Vertices are named [v0, v1, …] and faces [f0, f1, …] in the order of the file, unless the file
    names them. Errors are located in the file. *)
