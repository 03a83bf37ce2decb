(** Systems of linear equalities in reduced echelon form: the first variable of an equality occurs in no other
    equality. A solvable system has exactly one such form. *)

type t

val empty : t
(** The system without equalities. *)

val add : t -> Constraint.t -> t option
(** The system with one more equality; [None] if it then has no solution. A constraint that is no equality is a
    bug. *)

val of_list : Constraint.t list -> t option
(** The reduced echelon form of a list of equalities; [None] if they have no common solution. *)

val to_list : t -> Constraint.t list
(** The equalities of the reduced form, in the order of their first variables. *)

val rank : t -> int
(** The number of equalities of the reduced form. *)

val reduce : t -> Constraint.t -> Constraint.t
(** [reduce t c] is [c] without the first variables of the equalities of [t]. It is equivalent to [c] where
    these hold. *)
