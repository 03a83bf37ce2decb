(** What VRML and X3D files share: the node [IndexedFaceSet], as words. *)

open Scc_base
open Scc_geometry

type t = {
  points : Text.word list;  (** coordinates, three for each point *)
  index : Text.word list;  (** of points, from 0; -1 ends a face *)
  ccw : bool;  (** faces run counter-clockwise seen from outside *)
  at : Text.word;  (** the word [IndexedFaceSet] *)
  name : string option;  (** what [DEF] calls it, or the shape that it is of *)
}

val words : string -> int -> int -> Text.word list
(** [words text start stop]: parted by blanks, line ends and commas. *)

val moves : path:string -> string -> Text.word list -> (bool, Diag.t) result
(** Would this field of a Transform, of that name and value, move points? Not when it is the identity. *)

val to_ifs : path:string -> t list -> (Polyhedron.ifs, Diag.t) result
(** All sets of a file as one, in order. *)
