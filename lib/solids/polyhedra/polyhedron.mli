(** Convex polyhedra, not necessarily closed: the solutions of finitely many linear constraints, strict or not,
    over the variables 0 .. n - 1 of a space of dimension n. Everything is exact. Values are immutable.
    Emptiness is decided when a polyhedron is made; the minimal form is computed once, at its first use, and
    kept.

    Two polyhedra, forms and constraints that are used together have the same dimension (a bug otherwise). *)

open Scc_exact

type t

(** {1 Making} *)

val universe : int -> t
(** All points of the space of dimension n. *)

val empty : int -> t
(** The set without points, in the space of dimension n. *)

val of_constraints : int -> Constraint.t list -> t
(** [of_constraints n constraints] is the set of the points that satisfy all of them. *)

val of_point : Rat.t array -> t
(** The polyhedron with this point as its only one, in the space of as many dimensions as it has coordinates.
*)

val box : (Rat.t * Rat.t) array -> t
(** [box ranges] has the points whose coordinate i is between the two ends of [ranges.(i)], both included. *)

(** {1 What it is} *)

val dimension : t -> int
(** The dimension of the space: the number of variables. *)

val is_empty : t -> bool
(** [is_empty p] is true if [p] has no point. Takes constant time. *)

val is_universe : t -> bool
(** [is_universe p] is true if [p] has all points of its space. *)

val constraints : t -> Constraint.t list
(** The minimal form: equalities in reduced echelon form, including those that follow from inequalities alone,
    then inequalities. The inequalities do not mention the first variables of the equalities, and none follows
    from the rest. A closed polyhedron has one such form; others may have several, so compare polyhedra by
    {!equal}. The empty one has 0 < 0 alone. *)

val minimal : t -> t
(** The polyhedron as a value that is kept by its minimal form: later operations are quicker. *)

val equalities : t -> Constraint.t list
(** The equalities of the minimal form; none for the empty set. *)

val affine_dimension : t -> int
(** The dimension of the affine hull; -1 for the empty set. *)

val mem : t -> Rat.t array -> bool
(** [mem p x] is true if the point [x] is in [p]. A point of another dimension is a bug. *)

val point : t -> Rat.t array option
(** Some point of the polyhedron; [None] if it is empty. *)

val corner : t -> Rat.t array option
(** A point of the closure that lies on as many borders as possible: a vertex, if there are any. [None] if the
    polyhedron is empty. *)

val interior_point : t -> Rat.t array option
(** A point of the relative interior with simple coordinates; [None] if the polyhedron is empty. Coordinates
    are chosen one after the other, from variable 0 on, each the simplest fraction that is left. {b Simplest}
    is the least denominator, then the least absolute value. Where that denominator exceeds 100, the choice is
    limited to the middle half of the interval. *)

type bound = Simplex.bound = Unbounded | Bound of { value : Rat.t; attained : bool }

val supremum : t -> Linear.t -> bound option
(** [supremum p f] is the least upper bound of [f] on [p], and whether a point attains it; [None] if [p] is
    empty. *)

val infimum : t -> Linear.t -> bound option
(** [infimum p f] is the greatest lower bound of [f] on [p], and whether a point attains it; [None] if [p] is
    empty. *)

val limit : bound option -> Rat.t option
(** [limit b] is the value of a bound that exists. *)

val is_bounded : t -> bool
(** [is_bounded p] is true if some box contains [p]. The empty set is bounded. *)

val implies : t -> Constraint.t -> bool
(** [implies p c] is true if all points of [p] satisfy [c]. *)

(** {1 Comparing} *)

val included : t -> t -> bool
(** [included p q] is true if each point of [p] is a point of [q]. *)

val not_convex : t -> t -> bool
(** [not_convex p q] is true if a corner of one shows at a glance that the union of both is not convex. The corner
    is outside of the closure of the other one, which has a point beyond a face at the corner. So the way from the
    corner to that point begins outside of both closures. If it is false, nothing follows. *)

val equal : t -> t -> bool
(** [equal p q] is true if both have the same points. *)

val disjoint : t -> t -> bool
(** [disjoint p q] is true if no point is in both. *)

(** {1 Others that it gives rise to} *)

val add : t -> Constraint.t -> t
(** [add p c] has the points of [p] that satisfy [c]. *)

val add_all : t -> Constraint.t list -> t
(** [add_all p constraints] has the points of [p] that satisfy all constraints. *)

val inter : t -> t -> t
(** The intersection of both. *)

val closure : t -> t
(** The topological closure: all strict constraints of the minimal form become non-strict. The closure of the
    empty set is empty. *)

val relative_interior : t -> t
(** The interior within the affine hull: all inequalities of the minimal form become strict. *)

val preimage : t -> dimension:int -> Linear.t array -> t
(** [preimage p ~dimension forms] has the points of a space of [dimension] variables that the forms map into
    [p]. It is computed by substitution of the forms for the variables. *)

val substitute : t -> int -> Linear.t -> t
(** [substitute p i f] has the points x for which the point with f(x) in place of x{_i} is in [p]. *)

val embed : t -> dimension:int -> int array -> t
(** [embed p ~dimension at] is [p] in a space of [dimension] variables, where x{_i} gets the number [at.(i)].
    These numbers are distinct; the other variables are unconstrained. *)

val project : t -> int array -> t
(** [project p onto] has the points (x{_onto.(0)}, x{_onto.(1)}, ...) for all points x of [p]. The variables in
    [onto] are distinct (a bug otherwise). With all variables it is a permutation of the coordinates. *)

val image : t -> Linear.t array -> t
(** [image p forms] has the points (forms.(0)(x), forms.(1)(x), ...) for all points x of [p]. *)
