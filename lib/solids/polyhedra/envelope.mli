(** Polyhedra that are made of constraints of others. *)

val join : Polyhedron.t -> Polyhedron.t -> Polyhedron.t
(** [join p q]: the constraints of either, equalities taken as two inequalities and strict ones also without
    strictness, that hold on both. It contains both, and also their convex hull, which may be smaller: the
    {e envelope} of A. Bemporad, K. Fukuda and F. Torrisi, {e Convexity recognition of the union of polyhedra}
    (2001). The other one if one is empty. *)

val merge : Polyhedron.t -> Polyhedron.t -> Polyhedron.t option
(** The union, if it is a polyhedron: if it is, it is the {!join}, but for faces of that, which may be missing: of
    x > 0, y >= 0 and of y > 0, x + y >= 0 it is all of the join but (0, 0). *)

val widen : Polyhedron.t -> Polyhedron.t -> Polyhedron.t
(** [widen old next]: the constraints of [old], equalities taken as two inequalities, that hold on [next]. It
    contains both, and a sequence in which each is widened by something comes to rest: P. Cousot and N.
    Halbwachs, {e Automatic discovery of linear restraints among variables of a program} (POPL 1978), without
    their second step. [next] if [old] is empty. *)
