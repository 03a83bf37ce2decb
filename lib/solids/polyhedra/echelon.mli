(** Systems of linear equalities in reduced echelon form: each gives its first variable, which occurs in no other
    one. A solvable system has exactly one such form. *)

type t

val empty : t

val add : t -> Constraint.t -> t option
(** One more equality; [None] if the system has no solution with it. *)

val of_list : Constraint.t list -> t option
(** Of equalities. *)

val to_list : t -> Constraint.t list
(** By their first variables. *)

val rank : t -> int
(** The number of equalities. *)

val reduce : t -> Constraint.t -> Constraint.t
(** The constraint, where the equalities hold, without the variables that they give. *)
