(** Polyhedra around two others, for proofs by over-approximation. They are as tight as the directions permit
    that are considered. The convex hull would be tighter, but may have exponentially many borders. *)

open Scc_exact

val affine : through:Rat.t array -> Rat.t array list -> Constraint.t list
(** [affine ~through vectors] has the equalities of the least affine space that contains the point and is
    closed under adding multiples of the vectors. *)

val join : directions:Linear.t list -> Polyhedron.t -> Polyhedron.t -> Polyhedron.t
(** [join ~directions p q] is the least polyhedron that contains both, among those with the equalities that
    both satisfy and with planes in certain directions. The directions are the given ones, both ways, and those
    of the borders of both. The affine hull is exact: M. Karr, {e Affine relationships among variables of a
    program} (1976). The planes are those of the weak join of S. Sankaranarayanan, M. Colón, H. Sipma and Z.
    Manna, {e Efficient strongly relational polyhedral analysis} (VMCAI 2006). If one of the two is empty, it
    is the other one. *)
