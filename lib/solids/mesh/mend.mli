(** Repairs of a mesh, on request, so that it becomes the boundary of a solid. Each function returns a sentence
    for readers that says what was changed. {!Mesh.read} does none of this. Indices are in range (a bug
    otherwise). All take near linear time. *)

open Scc_exact
open Scc_geometry

val on_grid : Rat.t -> Polyhedron.ifs -> Polyhedron.ifs * string
(** [on_grid d set] rounds every coordinate to the nearest multiple of [d] > 0: points move by at most half of
    it along each axis. The sentence has the number of points moved, and the farthest. *)

val closing_grid : Polyhedron.ifs -> Rat.t option
(** [closing_grid set] is the least power of ten, from 1e-9 to 1e-4 of the greatest coordinate, after which
    {!on_grid} and {!weld} leave no edge that is in one face only. [None] if there is none, or if {!weld} alone is
    enough. *)

val weld : Polyhedron.ifs -> Polyhedron.ifs * string
(** Vertices at one point become one, which has the name of the first. Corners that repeat their neighbour are
    dropped, and so are faces with fewer than three corners left, and faces that are there twice, as
    {!Twice.single} has it. A face without an area goes, and its neighbours take in its corners ({!Slivers}). If
    each face is there from both sides, the first of both stays. Vertices that no face uses are dropped, but
    not in a cloud, which has no faces. *)

val is_open : Polyhedron.ifs -> bool
(** [is_open set] is true if some edge is in one face only. *)

val has_faces_twice : Polyhedron.ifs -> bool
(** [has_faces_twice set] is true if {!weld} drops a face that is there twice, with the same vertices. *)

type consistent = {
  turned : bool array;  (** For each face, whether it is to be turned over. *)
  closed : int list list;
  (** The faces of each piece all of whose edges have as many of them one way as the other way, once these are
      turned over. Faces and pieces are in order. *)
}

val all_closed : consistent -> bool
(** True if all faces are in closed pieces. *)

val consistent : Polyhedron.ifs -> (consistent, string) result
(** A piece is faces that are connected by edges of exactly two faces. They are turned over so that any two
    neighbours agree with the first face of their piece. Two faces with the same corners are a piece by themselves,
    if all pieces are closed then. [Error]: a surface like a Möbius strip, with a face at
    which it was found. *)

val merge : Polyhedron.ifs -> Polyhedron.ifs * string
(** The set with maximal faces, by {!Merge_coplanar.merge}. A cloud of points, without faces, stays as it is.
    The sentence has the numbers of faces before and after. *)
