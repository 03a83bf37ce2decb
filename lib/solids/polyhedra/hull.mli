(** Polyhedra around two others, for proofs by over-approximation: as tight as directions that are looked in let
    them be, without the cost of the convex hull, which may have exponentially many borders. *)

open Scc_exact

val affine : through:Rat.t array -> Rat.t array list -> Constraint.t list
(** The least affine space through a point that goes on in the directions of these vectors: its equalities. *)

val join : directions:Linear.t list -> Polyhedron.t -> Polyhedron.t -> Polyhedron.t
(** The least polyhedron that contains both and is bounded by the equalities that both satisfy (their affine hull
    is exact: M. Karr, {e Affine relationships among variables of a program}, 1976), and by planes in the
    directions that are given, each both ways, and in those of the borders of both. These are moved as far out as
    they must: the weak join of S. Sankaranarayanan, M. Colón, H. Sipma and Z. Manna, {e Efficient strongly
    relational polyhedral analysis} (VMCAI 2006). The other one if one is empty. *)
