(** Finite unions of convex polyhedra, not necessarily closed, in one space: the sets that Boolean combinations
    of linear constraints describe. Sets that are used together have the same dimension (a bug otherwise). *)

open Scc_exact

type t

(** {1 Making} *)

val empty : int -> t
(** The set without points, in the space of dimension n. *)

val universe : int -> t
(** All points of the space of dimension n. *)

val of_polyhedra : int -> Polyhedron.t list -> t
(** [of_polyhedra n polyhedra] is the union of polyhedra in a space of dimension n (another dimension is a
    bug). Empty ones are dropped. *)

val of_polyhedron : Polyhedron.t -> t
(** The set of the points of one polyhedron. *)

(** {1 What it is} *)

val dimension : t -> int
(** The dimension of the space. *)

val pieces : t -> Polyhedron.t list
(** Polyhedra, none empty, whose union is the set. They may overlap. *)

val is_empty : t -> bool
(** [is_empty u] is true if the set has no point. Takes constant time. *)

val mem : t -> Rat.t array -> bool
(** [mem u x] is true if the point [x] is in some piece. *)

val point : t -> Rat.t array option
(** A point with simple coordinates: {!Polyhedron.interior_point} of the first piece. [None] if the set is
    empty. *)

(** {1 Comparing} *)

val covers : t -> Polyhedron.t -> bool
(** [covers u p] is true if each point of [p] is in [u]. *)

val outside : t -> Polyhedron.t -> Rat.t array option
(** [outside u p] is a point of [p] that is not in [u], or [None] if there is none. *)

val equal : t -> t -> bool
(** [equal u v] is true if both have the same points. *)

(** {1 Operations} *)

val union : t -> t -> t
(** The union; the pieces of the first set, then those of the second. *)

val inter : t -> t -> t
(** The intersection: the non-empty intersections of a piece of each. *)

val difference : t -> t -> t
(** [difference u v] has the points of [u] that are not in [v]. *)

val map : dimension:int -> (Polyhedron.t -> Polyhedron.t) -> t -> t
(** [map ~dimension f u] is the union of [f] of each piece, in a space of [dimension] variables. It is meant
    for operations that commute with unions, as projections and preimages do. *)

val disjoint : t -> t
(** The set, by pieces that do not overlap. *)

val add_merged : Polyhedron.t -> Polyhedron.t list -> Polyhedron.t list
(** [add_merged p pieces] adds a piece to pieces of which no two have a convex union, and merges it with others
    as {!merged} does. No two pieces of the result can be merged. *)

val merged : t -> t
(** The set, by fewer pieces where possible. Pieces that others contain are dropped, and two pieces become one
    if their union is convex, until there are no such two. *)
