(** Linear constraints a.x < b, a.x <= b and a.x = b over n variables. They are kept in one form: integers
    without a common factor, and in an equality the first coefficient that is not 0 is positive. So each
    half-space and each hyperplane has one constraint. *)

open Scc_exact

type relation = Less | At_most | Equal

type t = private { normal : Z.t array; relation : relation; right : Z.t }
(** normal.x relation right. *)

(** {1 Making} *)

val make : Z.t array -> relation -> Z.t -> t
(** Brings it to the one form. *)

val of_form : Linear.t -> relation -> t
(** [of_form f relation]: f relation 0. *)

val less : Linear.t -> Linear.t -> t
val at_most : Linear.t -> Linear.t -> t
val greater : Linear.t -> Linear.t -> t
val at_least : Linear.t -> Linear.t -> t

val equals : Linear.t -> Linear.t -> t
(** [less f g] is f < g, and so on. *)

(** {1 Asking} *)

val dimension : t -> int

val to_form : t -> Linear.t
(** normal.x - right: the constraint says that it is related so to 0. *)

val truth : t -> bool option
(** Of a constraint in which no variable occurs: whether it holds. *)

val mem : t -> Rat.t array -> bool
(** Whether a point satisfies it. *)

val mentions : t -> int -> bool
(** Whether the variable occurs. *)

val first_variable : t -> int option

val equal : t -> t -> bool

val follows : t -> from:t -> bool
(** Whether the constraint follows from another one that says no less of the very same normal; false of many that
    follow by some reckoning. *)

val compare : t -> t -> int
(** A total order: equalities first, then by normals; of those with one normal, the tightest first. *)

val same_normal : t -> t -> bool
val hash : t -> int

(** {1 Others that it gives rise to} *)

val halves : t -> t list
(** An equality as two inequalities; another one alone. *)

val negation : t -> t list
(** Constraints of which a point satisfies exactly one if it does not satisfy this one, and none if it does: one
    for an inequality, two for an equality. *)

val strict : t -> t
(** With < for <=. *)

val closed : t -> t
(** With <= for <. *)

val tight : t -> t
(** With = for < or <=: its boundary. *)

val eliminate : t -> int -> by:t -> t
(** [eliminate c i ~by] is c without x{_i}, where the equality [by], in which x{_i} occurs, holds. *)

val resolve : t -> t -> int -> t
(** [resolve c d i] is what two inequalities that bound x{_i} from above and from below say together without it:
    a sum of positive multiples of them, strict if either is. *)

val rename : t -> dimension:int -> int array -> t
(** [rename c ~dimension at] has variable number [at.(i)], of so many, for each x{_i} that occurs. *)

val substitute : t -> dimension:int -> Linear.t array -> t
(** With a form over so many variables for each variable. *)
