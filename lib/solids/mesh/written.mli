(** Solids as files, exactly: coordinates are decimals. A number without a decimal, as 1/3, is a fraction p/q
    in OFF, OBJ and templates. {!Mesh.read} reads it; other programs may not. *)

open Scc_exact
open Scc_geometry

val endings : string list
(** The endings that {!to_file} knows: [.off], [.obj], [.stl], [.ply], and [.sc], a template of the
    language. *)

val to_file : path:string -> (Polyhedron.ifs -> (string, string) result) option
(** The writer for the ending of a name; [None] for an unknown ending. OBJ files name faces, as groups. OFF,
    PLY (as text) and STL files (as text, faces cut into triangles) have no names; a template, named after the
    file, keeps them. Faces are convex. [Error]: a vertex with a coordinate that has no decimal, in a format
    whose readers take no fractions (STL, PLY). *)

val rounded : Polyhedron.ifs -> (Polyhedron.ifs * int * Rat.t) option
(** The set with the nearest 64-bit numbers as coordinates, the number of coordinates changed, and the greatest
    change. Faces may not be flat any more. [None] if one is beyond the greatest number. *)

val name_of : path:string -> string
(** The name of the language for the solid of a file: the name of the file without its ending, with a
    capital. *)

val drawn : path:string -> Polyhedron.ifs -> string
(** A text in the language for a solid that need not be convex: a compound [decompose { … }] of mass 1, named
    after the file. *)
