(** VRML 2 (VRML97) and classic X3D files, as scenes. *)

val scene : path:string -> string -> int ref -> Scene.file
(** [scene ~path text room] is the scene of a file; instances of prototypes take from the [room] for nodes. Raises
    {!Scene.Refused} with an error (SC0320, SC0321) that is located in the file. *)
