(** VRML 2 (VRML97) and classic X3D files: every node [IndexedFaceSet] with its own [Coordinate]. Other nodes
    are skipped, but fields of a Transform that would move points, and [USE], [PROTO] and
    [Inline], are errors: the shape would not be the one that a viewer shows. *)

open Scc_base
open Scc_geometry

val read : path:string -> string -> (Polyhedron.ifs, Diag.t) result
