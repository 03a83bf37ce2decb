(** Solids as files, exactly: coordinates are decimals. Where a number has none, as 1/3, OFF, OBJ and templates
    have the fraction p/q, which {!Mesh.read} understands and other programs may not. *)

open Scc_exact
open Scc_geometry

val endings : string list
(** [.off], [.obj], [.stl], [.ply], and [.sc]: a template of the language, named after the file. *)

val to_file : path:string -> (Polyhedron.ifs -> (string, string) result) option
(** By the ending of the name. OBJ files name faces, as groups; OFF, PLY (as text) and STL files (as text, faces
    cut into triangles) lose all names; a template keeps them. Faces are convex. [Error]: a vertex that has a
    coordinate without a decimal, in a format of which no reader takes fractions (STL, PLY). *)

val rounded : Polyhedron.ifs -> (Polyhedron.ifs * int * Rat.t) option
(** With the nearest 64-bit numbers as coordinates: how many of these changed, and by how much at most. Faces
    may not be flat any more. [None] when one is beyond the greatest number. *)

val name_of : path:string -> string
(** A name of the language for what a file has: its name without the ending, with a capital. *)

val drawn : path:string -> Polyhedron.ifs -> string
(** In the language, a solid that need not be convex: a compound [decompose { … }] of mass 1, named after the
    file. *)
