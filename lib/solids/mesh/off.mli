(** OFF files (Geomview): the word [OFF], the numbers of vertices, faces and edges, then a line for each
    vertex [x y z] and for each face [k i1 … ik], from 0. [COFF], [NOFF], [STOFF] and their combinations are
    read without their colours, normals and texture coordinates; a colour after a face is skipped. The
    number of edges, which many writers leave 0, is not used. *)

open Scc_base
open Scc_geometry

val read : path:string -> string -> (Polyhedron.ifs, Diag.t) result
