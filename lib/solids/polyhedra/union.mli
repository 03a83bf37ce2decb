(** Finite unions of convex polyhedra, not necessarily closed, in one space: all sets that linear constraints
    describe by and, or and not. Sets that are used together have the same dimension (a bug otherwise). *)

open Scc_exact

type t

(** {1 Making} *)

val empty : int -> t
val universe : int -> t

val of_polyhedra : int -> Polyhedron.t list -> t
(** The union of polyhedra in a space of that dimension; the empty ones are dropped. *)

val of_polyhedron : Polyhedron.t -> t

(** {1 What it is} *)

val dimension : t -> int

val pieces : t -> Polyhedron.t list
(** Polyhedra, none empty, whose union it is; they may overlap. *)

val is_empty : t -> bool
val mem : t -> Rat.t array -> bool

val point : t -> Rat.t array option
(** A point with simple coordinates: {!Polyhedron.interior_point} of the first piece. *)

(** {1 Comparing} *)

val covers : t -> Polyhedron.t -> bool
(** Whether each point of the polyhedron is in the set. *)

val outside : t -> Polyhedron.t -> Rat.t array option
(** A point of the polyhedron that is not in the set, if there is one. *)

val included : t -> t -> bool
(** [included u v]: whether each point of u is in v. *)

val equal : t -> t -> bool
(** The same points. *)

(** {1 Operations} *)

val union : t -> t -> t
val inter : t -> t -> t
val difference : t -> t -> t

val complement : t -> within:t -> t
(** What is in [within] and not in the set. *)

val map : dimension:int -> (Polyhedron.t -> Polyhedron.t) -> t -> t
(** Piece by piece, into a space of that dimension: for operations that commute with unions, as projection and
    preimages do. *)

val disjoint : t -> t
(** The same set by pieces that do not overlap. *)

val add_merged : Polyhedron.t -> Polyhedron.t list -> Polyhedron.t list
(** A piece more among pieces of which no two can be merged, likewise. *)

val merged : t -> t
(** The same set by fewer pieces, if it can be: pieces in others are dropped, and two pieces become one
    wherever their union is convex, until there are no such two. *)
