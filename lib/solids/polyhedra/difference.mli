(** What is left of a polyhedron without another. *)

val pieces : Polyhedron.t -> Polyhedron.t -> Polyhedron.t list
(** [pieces p q]: disjoint polyhedra, none empty, whose union is p without q. One constraint of q after the other
    is negated, where those before it hold. *)
