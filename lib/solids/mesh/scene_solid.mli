(** The faces that a scene of VRML or X3D shows at its start. *)

open Scc_base
open Scc_geometry

val read :
  files:Beside.reader ->
  scene:(Scene_library.t -> path:string -> string -> Scene.file) ->
  prototypes:(Scene_library.t -> path:string -> start:int -> depth:int -> string -> Scene_library.file) ->
  path:string ->
  string ->
  (Polyhedron.ifs * Diag.t list, Diag.t) result
(** [read ~files ~scene ~prototypes ~path text] are all faces that the scene shows, by {!Scene_table}, moved by
    the transforms around them, in the order of the file. Faces have the name of their geometry, or else of its
    shape. The warnings are of what is read nearly (SC0323) and of what moves while time passes (SC0324). Nodes
    that are used again and again are refused (SC0320) beyond what files of that length can have. [scene
    library ~path text] is the scene of a file, and its faults are returned. [prototypes] has those of a file,
    as {!Scene_library.make} says. Files that an [Inline] or a prototype names are read beside the file that
    has it. One that is inside of itself is refused (SC0321), and so is one elsewhere. *)
