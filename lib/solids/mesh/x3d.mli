(** X3D files in XML: every element [IndexedFaceSet] with the element [Coordinate] in it. Other elements are
    skipped. A [Transform] that moves points is an error, and so are [USE], [ProtoInstance] and [Inline]: the
    shape would differ from the one that a viewer shows. *)

open Scc_base
open Scc_geometry

val read : path:string -> string -> (Polyhedron.ifs, Diag.t) result
(** [read ~path text] is the set of all faces of a file. Errors (SC0320) are located in the file. *)
