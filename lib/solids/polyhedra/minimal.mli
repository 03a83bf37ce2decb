(** Descriptions of polyhedra without redundant constraints. *)

type t = private {
  equalities : Constraint.t list;  (** in reduced echelon form; equalities that follow from inequalities alone
                                       are included *)
  inequalities : Constraint.t list;
  (** without the first variables of the equalities; none follows from the rest; in the order of
      {!Constraint.compare} *)
  simplex : Simplex.t;  (** of these constraints *)
}

val make : Simplex.t -> Constraint.t list -> t
(** [make simplex constraints] is a minimal form of these constraints, of which [simplex] is the system. A
    polyhedron without strict constraints has exactly one minimal form. Others may have several: x, y >= 0 with
    x + y > 0, or with x + 2y > 0. *)

val constraints : t -> Constraint.t list
(** The equalities, then the inequalities. *)
