(** Feasibility of linear constraints, and bounds of linear functions under them. This is the general simplex
    method of B. Dutertre and L. de Moura, {e A fast linear-arithmetic solver for DPLL(T)} (CAV 2006). Bland's
    rule guarantees that it ends. Strict constraints are constraints on numbers q + k delta, where delta is
    positive and as small as need be. All numbers are integers over one common denominator, after J. Edmonds:
    no greatest common divisors are computed.

    Values are immutable: adding a constraint returns a new system, and the old one remains valid. All
    variables are in one dictionary; {!Simplex} has one dictionary for each block of variables that constraints
    join. *)

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
(** [universe n] is the system over n variables without constraints. *)

val add : t -> Constraint.t -> t option
(** The system with one more constraint, whose number is the count of those before it, from 0 on. [None] if no
    point satisfies all. *)

val join : t list -> t
(** Several systems without common variables as one system. The variables of the first come first, then those
    of the second, and so on; the constraints are numbered alike. *)

val value : t -> Z.t array -> Rat.t * Rat.t
(** [value t normal] is the value of normal.x at the current point of the solver: the q and the k of q + k
    delta. *)

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

val cornered : t -> t
(** [cornered t] is the system [t] whose current point is a vertex of the closure, if there are any. All of
    x{_0}, ..., x{_n-1} are basic then. *)

val pivot : t -> int -> int -> t
(** [pivot t r c] exchanges the variable of row r and that of column c, whose entry there is not 0. The new
    current point may violate constraints. *)

val closed_point : t -> Rat.t array
(** A point that satisfies all constraints when strict ones are taken as not strict: a vertex, if there are
    any. *)

type bound = Unbounded | Bound of { value : Rat.t; attained : bool }

val supremum : t -> Linear.t -> bound
(** [supremum t f] is the least upper bound of [f] on the system, and whether some point attains it. *)

val infimum : t -> Linear.t -> bound
(** [infimum t f] is the greatest lower bound of [f] on the system, and whether some point attains it. *)
