(** Systems of linear equalities in reduced echelon form: the first variable of an equality occurs in no other
    equality. A solvable system has exactly one such form. *)

type t

val of_list : Constraint.t list -> t option
(** The reduced echelon form of a list of equalities; [None] if they have no common solution. *)

val to_list : t -> Constraint.t list
(** The equalities of the reduced form, in the order of their first variables. *)

val reduce : t -> Constraint.t -> Constraint.t
(** [reduce t c] is [c] without the first variables of the equalities of [t]. It is equivalent to [c] where
    these hold. *)
