(** Constraints of a polyhedron none of which can be left out. *)

type t = private {
  equalities : Constraint.t list;  (** in reduced echelon form, those that hold by the inequalities alone
                                       included *)
  inequalities : Constraint.t list;
  (** without the variables that the equalities give; none follows from the equalities and the other ones; in the
      order of {!Constraint.compare} *)
  simplex : Simplex.t;  (** of these constraints *)
}

val make : Simplex.t -> Constraint.t list -> t
(** [make simplex constraints], where the simplex is that of the constraints. For a polyhedron without strict
    constraints there is one result, whatever constraints describe it; for others there may be several: x, y >= 0
    with x + y > 0, or with x + 2y > 0. *)

val constraints : t -> Constraint.t list
(** The equalities first. *)
