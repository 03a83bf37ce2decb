(** Faces turned over so that they look out of a solid. *)

open Scc_geometry

type t = {
  set : Polyhedron.ifs;
  turned : int list;  (** Faces that were turned over, in order. *)
  hollows : int list;  (** The first face of each piece that is a hollow. *)
}

val make : Polyhedron.ifs -> (t, string) result
(** Neighbours are made to agree ({!Scc_mesh.Mend.consistent}), and then each closed piece is turned as a whole:

    - A piece that lies within other ones is a hollow if their number is odd, and a solid if it is even. A piece
      lies within another one of greater volume if the latter surrounds all that the former does. Both may have
      points of the surface in common.
    - Any other piece is a solid. But it stays a hollow if it is one to begin with, and others together surround
      all that it surrounds. A copy of another one is no hollow of it.

    Where faces cross themselves, boxes tell what is within what. [Error]: a surface of one side, or more than 1000
    pieces. *)

val pieces : Polyhedron.ifs -> int
(** The number of pieces if all are closed; 0 if some are not. *)

val told : t -> string
(** A sentence on what was turned over. *)
