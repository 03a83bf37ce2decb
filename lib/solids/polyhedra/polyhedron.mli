(** Convex polyhedra, not necessarily closed: the solutions of finitely many linear constraints, strict or not,
    over the variables 0 .. n - 1 of a space of dimension n. Everything is exact. A value is never changed; what
    it takes to know is found once and kept with it, such as whether there is a point, or the minimal form.

    Two polyhedra, forms and constraints that are used together have the same dimension (a bug otherwise). *)

open Scc_exact

type t

(** {1 Making} *)

val universe : int -> t
(** All points. *)

val empty : int -> t
val of_constraints : int -> Constraint.t list -> t

val of_point : Rat.t array -> t
(** This point alone. *)

val box : (Rat.t * Rat.t) array -> t
(** The points whose coordinates are in these ranges, the ends included. *)

(** {1 What it is} *)

val dimension : t -> int
(** Of the space. *)

val is_empty : t -> bool
(** At once. *)

val is_universe : t -> bool

val constraints : t -> Constraint.t list
(** The minimal form: equalities in reduced echelon form, also those that only inequalities together imply, and
    inequalities that do not mention what these give, none of which follows from the rest. For a closed polyhedron
    there is one such form; one that is not closed may have several, so compare polyhedra by {!equal}. Of the
    empty one 0 < 0 alone. *)

val minimal : t -> t
(** The same polyhedron, kept by its minimal form alone: quicker to work with. *)

val equalities : t -> Constraint.t list
(** Those of the minimal form. *)

val affine_dimension : t -> int
(** Of its affine hull; -1 when it is empty. *)

val mem : t -> Rat.t array -> bool

val point : t -> Rat.t array option
(** A point of it; [None] when it is empty. *)

val corner : t -> Rat.t array option
(** A point of the closure on as many borders as any: a vertex of it, if it has vertices. *)

val interior_point : t -> Rat.t array option
(** A point of its relative interior, with simple coordinates: each is the simplest fraction that is left, first
    that of variable 0. {b Simplest} is the least denominator, then the least size; where that denominator is more
    than 100, it is the simplest one of the middle half of what is left. [None] when it is empty. *)

type bound = Simplex.bound = Unbounded | Bound of { value : Rat.t; attained : bool }

val supremum : t -> Linear.t -> bound option
(** The least number that the form does not exceed on it, and whether a point attains it; [None] when it is
    empty. *)

val infimum : t -> Linear.t -> bound option

val is_bounded : t -> bool
(** Whether it is in some box, as the empty one is. *)

val implies : t -> Constraint.t -> bool
(** Whether all its points satisfy the constraint. *)

val is_closed : t -> bool
(** Whether no strict constraint is needed to describe it. *)

(** {1 Comparing} *)

val included : t -> t -> bool
(** [included p q]: whether each point of p is one of q. *)

val equal : t -> t -> bool
(** The same points. *)

val disjoint : t -> t -> bool

val hash_of_closure : t -> int
(** The same for equal polyhedra, and for those that differ in whether their borders belong to them. *)

(** {1 Others that it gives rise to} *)

val add : t -> Constraint.t -> t
(** Where the constraint holds as well. *)

val add_all : t -> Constraint.t list -> t
val inter : t -> t -> t

val closure : t -> t
(** With its borders; the closure of the empty one is empty. *)

val relative_interior : t -> t

val preimage : t -> dimension:int -> Linear.t array -> t
(** [preimage p ~dimension forms], forms over so many variables: the points that they map into p. This is
    substitution of forms for the variables. *)

val substitute : t -> int -> Linear.t -> t
(** [substitute p i f]: the points that are in p once their coordinate i has been set to f of them. *)

val embed : t -> dimension:int -> int array -> t
(** [embed p ~dimension at]: in a space of so many variables, where x{_i} has the number [at.(i)], different for
    each, and nothing is said of the other variables. *)

val project : t -> int array -> t
(** [project p onto]: what p says of some variables alone, where [onto.(k)], all different, is the one that gets
    number k: the points (x{_onto.(0)}, x{_onto.(1)}, ...) of all points x of p. With all variables this is a
    permutation. *)

val eliminate : t -> int list -> t
(** The points that get into p if the coordinates of these numbers may be changed. *)

val image : t -> Linear.t array -> t
(** The points to which forms over its variables, one for each coordinate, map it. *)
