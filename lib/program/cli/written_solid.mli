(** Solids written to files. *)

open Scc_base
open Scc_geometry

type output = string * (Polyhedron.ifs -> (string, string) result)
(** The name of the file, and its format ({!Scc_mesh.Written.to_file}). *)

val drawn : output -> hint:string -> Polyhedron.ifs -> (unit, Diag.t list) result
(** A sound solid ({!Scc_concave.Sound}), convex or not; in the language one that is no template is a compound.
    SC0103 where the file cannot be written, or has no fractions and needs one: with the hint. *)

val convex : Console.t -> round:bool -> output -> Polyhedron.ifs -> (unit, Diag.t list) result
(** One that is accepted; with [round], and a note on what that did, with 64-bit numbers as coordinates. *)

val concave : Console.t -> round:bool -> output -> Polyhedron.ifs -> (unit, Diag.t list) result
(** One that is not: written if its faces bound a solid nevertheless, with a note on who takes it. *)
