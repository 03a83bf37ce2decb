(** Whether linear constraints have a common solution, and how great a linear function gets under them. Variables
    that no constraint has together, directly or by others, are in systems of their own ({!Tableau}): what is
    asked of hundreds of variables takes as long as what it takes for those that have to do with each other.

    A value is never changed: constraints are added to a system that has a solution, which stays where it is. *)

open Scc_exact

type t
(** Constraints on x{_0}, ..., x{_n-1}, all of which some point satisfies; the solver stands at such a point. *)

val universe : int -> t
(** No constraints on so many variables. *)

val dimension : t -> int

val add : t -> Constraint.t -> t option
(** One more constraint, which gets the next number, from 0 on. [None] if no point satisfies all. *)

val of_constraints : int -> Constraint.t list -> t option
(** All of them, in this order. *)

val satisfies : t -> Constraint.t -> bool
(** Whether the point at which the solver stands satisfies the constraint. If not, there is a point of the system
    that does not; if so, nothing follows for others. *)

val implies : t -> Constraint.t -> bool
(** Whether all points of the system satisfy the constraint. *)

val is_redundant : t -> int -> bool
(** Whether the constraint of this number, which is no equality, follows from the others. *)

val without : t -> int -> t
(** Forgets the constraint of this number, which is no equality. The others keep their numbers. *)

val point : t -> Rat.t array
(** A point that satisfies all constraints. *)

val closed_point : t -> Rat.t array
(** A point that satisfies all constraints if strict ones are taken as not strict: a vertex, if there are any. *)

type bound = Tableau.bound = Unbounded | Bound of { value : Rat.t; attained : bool }

val supremum : t -> Linear.t -> bound
(** The least number that the form does not exceed, and whether some point of the system reaches it. *)

val infimum : t -> Linear.t -> bound
