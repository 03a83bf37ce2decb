(** VRML 2 (VRML97) and classic X3D files, as scenes. *)

val scene : Scene_library.t -> path:string -> string -> Scene.file
(** [scene library ~path text] is the scene of a file; instances of prototypes take from the library's room for
    nodes. Raises {!Scene.Refused} with an error (SC0320, SC0321) that is located in the file. *)

val prototypes : Scene_library.t -> path:string -> start:int -> depth:int -> string -> Scene_library.file
(** [prototypes library ~path ~start ~depth text] has the prototypes that a file declares. Words have places that
    are counted from [start] on, as {!Scene_library.make} says. *)
