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
(** [too_fine set] is true if the coordinates over their common denominator would take more than 2^30 bits. A
    small file could so ask for a lot of memory. Such sets are to be refused before {!of_ifs}. *)

val of_ifs : ifs -> (t, Polyhedron_fault.t list) result
(** [of_ifs set] accepts exactly the convex closed polyhedra: those for which E0 to E5 of the rule book hold.
    Otherwise it returns the faults that a user should see, the most telling first. *)

val of_convex : ifs -> t
(** [of_convex set] is {!of_ifs} without a check: for sets that are convex closed polyhedra as they were made. *)

val renamed : vertices:string array -> faces:string array -> t -> t
(** The polyhedron under other names, which are distinct. *)

val to_ifs : t -> ifs
(** The vertices and faces of a polyhedron as an indexed face set. *)

val transform : Mat.t -> t -> t
(** The image under a linear map of positive determinant (a bug otherwise). It is a convex closed polyhedron
    again. *)

(** {1 Definitions 4.1 and 4.2} *)

val rotation_equivalent : int array -> int array -> bool
(** Definition 4.1: [rotation_equivalent f g] is true if the tuples are equal up to rotation. Reversed tuples
    are not. *)

val downgrade : t -> Feature.t -> Feature.t list
(** Definition 4.2, dg: the two vertices of an edge, the edges of a face, the empty list for a vertex. *)

val closure : t -> Feature.t list -> Feature.t list
(** Definition 4.2: the features with all their edges and vertices, sorted, without repetition. *)

(** {1 Names} *)

val find_vertex : t -> string -> int option
(** The index of the vertex with this name. *)

val find_face : t -> string -> int option
(** The index of the face with this name. *)

val find_edge : t -> int -> int -> int option
(** The index of the edge between two vertices, in either order. *)

val find_cycle : t -> int array -> int option
(** The index of the face that is rotation equivalent to the tuple (Definition 4.1). *)

val feature_name : t -> Feature.t -> string
(** [a] for a vertex, [top] for a face, [[a,b]] for an edge. *)

val equal : t -> t -> bool
(** [equal p q] is true if names, positions and faces are the same, in the same order. *)
