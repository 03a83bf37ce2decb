(** Solids as files, exactly: coordinates are decimals where these are exact in twelve places, and else fractions
    p/q, as {!Mesh.read} understands them (other programs may not). *)

open Scc_geometry

val endings : string list
(** [.off], [.obj], and [.sc]: a template of the language, named after the file. *)

val to_file : path:string -> (Polyhedron.ifs -> string) option
(** By the ending of the name. OBJ files name faces, as groups; OFF files lose all names; a template keeps them. *)

val name_of : path:string -> string
(** A name of the language for what a file has: its name without the ending, with a capital. *)
