(** The faces that a scene of VRML or X3D shows at its start. *)

open Scc_base
open Scc_geometry

val read : path:string -> size:int -> (int ref -> Scene.file) -> (Polyhedron.ifs * Diag.t list, Diag.t) result
(** [read ~path ~size scene] are all faces that the scene shows, by {!Scene_table}, moved by the transforms around
    them, in the order of the file. Faces have the name of their geometry, or else of its shape. The warnings are
    of what is read nearly (SC0323) and of what moves while time passes (SC0324). [size] is the length of the file:
    nodes that are used again and again are refused (SC0320) beyond what a file of that length can have. Faults of
    [scene room] are returned. *)
