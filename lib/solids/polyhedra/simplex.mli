(** Feasibility of linear constraints, and bounds of linear functions under them. Variables that no chain of
    constraints joins are in separate systems ({!Tableau}). So the time of a query depends on the variables
    that are joined to those of the query, not on all.

    Values are immutable: adding a constraint returns a new system, and the old one remains valid. *)

open Scc_exact

type t
(** Constraints on x{_0}, ..., x{_n-1}, all of which some point satisfies; the solver stands at such a point. *)

val universe : int -> t
(** [universe n] is the system over n variables without constraints. *)

val dimension : t -> int
(** The number n of variables. *)

val add : t -> Constraint.t -> t option
(** The system with one more constraint, whose number is the count of those before it, from 0 on. [None] if no
    point satisfies all. *)

val of_constraints : int -> Constraint.t list -> t option
(** [of_constraints n constraints] is the system of these constraints, numbered in this order from 0; [None] if
    no point satisfies all. *)

val satisfies : t -> Constraint.t -> bool
(** [satisfies t c] is true if the current point of the solver satisfies [c]. If it is false, some point of the
    system violates [c]; if it is true, nothing follows for other points. *)

val implies : t -> Constraint.t -> bool
(** [implies t c] is true if all points of the system satisfy [c]. *)

val is_redundant : t -> int -> bool
(** [is_redundant t k] is true if constraint number [k], which is no equality, follows from the others. *)

val without : t -> int -> t
(** [without t k] is the system without constraint number [k], which is no equality. The others keep their
    numbers. *)

val point : t -> Rat.t array
(** A point that satisfies all constraints, strict ones included. *)

val closed_point : t -> Rat.t array
(** A point that satisfies all constraints when strict ones are taken as not strict: a vertex, if there are
    any. *)

type bound = Tableau.bound = Unbounded | Bound of { value : Rat.t; attained : bool }

val supremum : t -> Linear.t -> bound
(** [supremum t f] is the least upper bound of [f] on the system, and whether some point attains it. *)

val infimum : t -> Linear.t -> bound
(** [infimum t f] is the greatest lower bound of [f] on the system, and whether some point attains it. *)
