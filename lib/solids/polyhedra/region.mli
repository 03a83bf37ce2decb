(** Sets of values, none empty, cut by constraints. *)

val where : Polyhedron.t -> Constraint.t list -> Polyhedron.t list
(** [where p constraints] is the region where all constraints hold, if it is not empty. *)

val split : Polyhedron.t -> Constraint.t list -> Polyhedron.t option * Polyhedron.t list
(** [split p constraints] is the region where all constraints hold, if it is not empty, and disjoint pieces of
    the rest. No piece is empty. *)
