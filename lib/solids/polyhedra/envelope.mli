(** Polyhedra that are made of constraints of others. *)

val join : Polyhedron.t -> Polyhedron.t -> Polyhedron.t
(** [join p q] has the constraints of either that hold on both. Equalities count as two inequalities, and
    strict constraints also without strictness. It contains both, and their convex hull, which may be smaller.
    This is the {e envelope} of A. Bemporad, K. Fukuda and F. Torrisi, {e Convexity recognition of the union of
    polyhedra} (2001). If one of the two is empty, it is the other one. *)

val merge : Polyhedron.t -> Polyhedron.t -> Polyhedron.t option
(** [merge p q] is the union of both if that is a polyhedron, else [None]. Such a union is the {!join} without
    some of its faces. Example: for x > 0, y >= 0 and y > 0, x + y >= 0 it is the join without (0, 0). *)

val widen : Polyhedron.t -> Polyhedron.t -> Polyhedron.t
(** [widen old next] has the constraints of [old], equalities taken as two inequalities, that hold on [next].
    It contains both, and a sequence of widenings becomes constant after finitely many steps. This is the
    widening of P. Cousot and N. Halbwachs, {e Automatic discovery of linear restraints among variables of a
    program} (POPL 1978), without their second step. If [old] is empty, it is [next]. *)
