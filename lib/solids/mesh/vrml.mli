(** VRML 2 (VRML97) and classic X3D files: every node [IndexedFaceSet] with its own [Coordinate]. Other nodes
    are skipped. Fields of a Transform that move points are errors, and so are [USE], [PROTO] and [Inline]: the
    shape would differ from the one that a viewer shows. *)

open Scc_base
open Scc_geometry

val read : path:string -> string -> (Polyhedron.ifs, Diag.t) result
(** [read ~path text] is the set of all faces of a file. Errors (SC0320) are located in the file. *)
