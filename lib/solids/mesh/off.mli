(** OFF files (Geomview). They have the word [OFF], the numbers of vertices, faces and edges, then a line for
    each vertex and each face. A vertex is [x y z], a face [k i1 … ik], with indices from 0. [COFF], [NOFF],
    [STOFF] and their combinations, in any order, are read without their colours, normals and texture coordinates,
    which a vertex has or has not; a colour after a face is skipped. [OFF] may be in small letters. All may be on
    one line, without colours. The number of edges, which many writers leave
    0, is not used. *)

open Scc_base
open Scc_geometry

val begins : string -> bool
(** [begins text] is true if the first word of the text is the head of an OFF file. *)

val read : path:string -> string -> (Polyhedron.ifs, Diag.t) result
(** [read ~path text] is the set of faces of a file. Errors (SC0320) are located in the file. *)
