(** Solids written to files. *)

open Scc_base
open Scc_geometry

type output = string * (Polyhedron.ifs -> (string, string) result)
(** The name of the file, and its format ({!Scc_mesh.Written.to_file}). *)

val drawn : hint:string -> (output * Polyhedron.ifs) list -> (unit, Diag.t list) result
(** Writes sound solids ({!Scc_concave.Sound}), convex or not, all of them or none. In the language of scc, one
    that is no template becomes a compound. A file that cannot be written, or a format without fractions for a
    solid that needs one, is SC0103 with the hint. *)

val templates : hint:string -> string -> (output * Polyhedron.ifs) list -> (unit, Diag.t list) result
(** [templates ~hint path solids] writes all of the solids to one file of the language, one after the other,
    each as {!drawn} would to a file of its own. *)

val convex : Console.t -> round:bool -> output -> Polyhedron.ifs -> (unit, Diag.t list) result
(** Writes a solid that is accepted. With [round], its coordinates become 64-bit numbers, and a note states the
    effect. *)

val concave : Console.t -> round:bool -> output -> Polyhedron.ifs -> (unit, Diag.t list) result
(** Writes a solid that is not accepted, if its faces bound a solid nevertheless, with a note on the commands
    that accept it. *)
