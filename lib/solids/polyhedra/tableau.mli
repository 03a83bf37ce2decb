(** Whether linear constraints have a common solution, and how great a linear function gets under them: the general
    simplex method of B. Dutertre and L. de Moura, {e A fast linear-arithmetic solver for DPLL(T)} (CAV 2006), with
    Bland's rule, by which it ends. Strict constraints are constraints on numbers q + k delta, where delta is
    positive and as small as need be. All is done in integers over one common denominator, after J. Edmonds:
    no greatest common divisors are taken.

    A value is never changed: constraints are added to a system that has a solution, which stays where it is. All
    variables are in one dictionary: {!Simplex} has one for each block of variables that constraints join. *)

open Scc_exact

type kind = Free | Slack | Fixed  (** a variable may be anything, at least 0, or 0 only *)

type t = private {
  dimension : int;
  kinds : kind array;
  (** of x{_0}, ..., x{_n-1}, which are free, and the slack of each constraint: right - normal.x *)
  basic : int array;  (** the variable of each row *)
  cobasic : int array;  (** the variable of each column; they are 0 where the solver stands *)
  rows : Z.t array array;
  (** denominator * basic = row.(0) + row.(1) delta + the sum of row.(2 + c) times the variable of column c *)
  denominator : Z.t;
  (** positive; if all of x{_0}, ..., x{_n-1} are basic, the size of the determinant of the normals of the
      constraints that are not *)
}
(** Constraints on x{_0}, ..., x{_n-1}, all of which some point satisfies; the solver stands at such a point. *)

val universe : int -> t
(** No constraints on so many variables. *)

val dimension : t -> int

val add : t -> Constraint.t -> t option
(** One more constraint, which gets the next number, from 0 on. [None] if no point satisfies all. *)

val join : t list -> t
(** Several systems that have no variable in common as one: the variables of the first come first, then those of
    the second, and so on, and so do the constraints. *)

val value : t -> Z.t array -> Rat.t * Rat.t
(** normal.x where the solver stands: q and k of q + k delta. *)

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

val cornered : t -> t
(** The same, standing at a vertex, if there are any, as far as strict constraints are taken as not strict: then
    all of x{_0}, ..., x{_n-1} are basic. *)

val pivot : t -> int -> int -> t
(** [pivot t r c]: the variable of row r and that of column c, whose entry there is not 0, change places. It may
    leave the solver where constraints do not hold. *)

val closed_point : t -> Rat.t array
(** A point that satisfies all constraints if strict ones are taken as not strict: a vertex, if there are any. *)

type bound = Unbounded | Bound of { value : Rat.t; attained : bool }

val supremum : t -> Linear.t -> bound
(** The least number that the form does not exceed, and whether some point of the system reaches it. *)

val infimum : t -> Linear.t -> bound
