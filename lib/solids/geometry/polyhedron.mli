(** Templates: indexed face sets W = V u F in body space that are convex closed polyhedra (Definitions 4.1
    to 4.3, readings I-1 and I-2). *)

open Scc_exact

type t = private {
  vertices : (string * Vec.t) array;  (** name and position in body space *)
  faces : (string * int array) array;
  (** name and vertex indices, counter-clockwise seen from outside *)
  edges : (int * int) array;
  (** unordered (reading I-1): the smaller index first; in lexicographic order *)
  topology : Topology.t;  (** of these edges *)
}

(** An indexed face set before any check. Names of vertices and of faces are distinct. *)
type ifs = { ifs_vertices : (string * Vec.t) array; ifs_faces : (string * int array) array }

val too_fine : ifs -> bool
(** The coordinates have so many different denominators that over their common one they would take more than
    2^30 bits: a small file could ask for a lot of memory. To be refused before {!of_ifs}. *)

val of_ifs : ifs -> (t, Polyhedron_fault.t list) result
(** Accepts exactly the convex closed polyhedra, that is E0 to E5 of the rule book hold; otherwise every
    fault that a person would want to see, the most telling first. *)

val to_ifs : t -> ifs

val transform : Mat.t -> t -> t
(** The image under a linear map of positive determinant (a bug otherwise), which stays one. *)

(** {1 Definitions 4.1 and 4.2} *)

val rotation_equivalent : int array -> int array -> bool
(** Definition 4.1: equal up to rotation of the tuple, not up to reversal. *)

val downgrade : t -> Feature.t -> Feature.t list
(** Definition 4.2, dg: the two vertices of an edge, the edges of a face, nothing for a vertex. *)

val closure : t -> Feature.t list -> Feature.t list
(** Definition 4.2: the features with all the edges and vertices of theirs, sorted, without repetition. *)

(** {1 Names} *)

val find_vertex : t -> string -> int option
val find_face : t -> string -> int option
val find_edge : t -> int -> int -> int option
(** The edge between two vertices, in either order. *)

val find_cycle : t -> int array -> int option
(** The face that is rotation equivalent to the tuple. *)

val feature_name : t -> Feature.t -> string
(** [a] for a vertex, [top] for a face, [[a,b]] for an edge. *)

val equal : t -> t -> bool
(** Same names, positions and faces. *)
