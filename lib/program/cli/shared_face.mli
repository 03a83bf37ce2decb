(** Solids of one mesh that share a face. *)

open Scc_geometry

val find : Polyhedron.ifs -> (string * string) option
(** The names of two faces with the same corners, in the two directions: the solids on both sides share that face.
    Corners are the same if their positions are. *)

val advice : Polyhedron.ifs -> string option
(** A line that names the two faces and says what takes such solids, if there are two. *)
