(** VRML 2 (VRML97) and classic X3D files, as scenes. *)

open Scc_base
open Scc_geometry

val read : path:string -> string -> (Polyhedron.ifs * Diag.t list, Diag.t) result
(** [read ~path text] is what {!Scene_solid.read} makes of a file. Errors (SC0320, SC0321) are located in the
    file. *)
