(** X3D files in XML: every element [IndexedFaceSet] with the element [Coordinate] in it. Other elements are
    skipped, but a [Transform] that would move points, and [USE], [ProtoInstance] and [Inline], are errors:
    the shape would not be the one that a viewer shows. *)

open Scc_base
open Scc_geometry

val read : path:string -> string -> (Polyhedron.ifs, Diag.t) result
