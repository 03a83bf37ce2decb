(** Differences of polyhedra. *)

val pieces : Polyhedron.t -> Polyhedron.t -> Polyhedron.t list
(** [pieces p q] are disjoint polyhedra, none empty, whose union is [p] without [q]. Each piece satisfies the
    negation of one constraint of [q] and the constraints before that one. *)
