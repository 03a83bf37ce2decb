(** The node [IndexedFaceSet], which VRML and X3D files share, as words. *)

open Scc_base
open Scc_geometry

type t = {
  points : Text.word list;  (** coordinates, three for each point *)
  index : Text.word list;  (** of points, from 0; -1 ends a face *)
  ccw : bool;  (** faces run counter-clockwise seen from outside *)
  name : string option;  (** the name given by [DEF], or that of its shape *)
}

val words : string -> int -> int -> Text.word list
(** [words text start stop] are the words of that part of the text, separated by blanks, line ends and
    commas. *)

val moves : path:string -> string -> Text.word list -> (bool, Diag.t) result
(** [moves ~path name words] is true if a field of a Transform with that name and value moves points. The
    identity does not. Values that are no numbers are errors (SC0320). *)

val to_ifs : path:string -> t list -> (Polyhedron.ifs, Diag.t) result
(** The set of faces of all nodes of a file, in order. *)
