(** Linear constraints a.x < b, a.x <= b and a.x = b over n variables. Each constraint is normalised: its
    numbers are integers without a common factor. The first coefficient of an equality that is not 0 is
    positive. So each half-space and each hyperplane has one constraint. *)

open Scc_exact

type relation = Less | At_most | Equal

type t = private { normal : Z.t array; relation : relation; right : Z.t }
(** The constraint normal.x relation right, normalised as said above. *)

(** {1 Making} *)

val make : Z.t array -> relation -> Z.t -> t
(** [make normal relation right] is the constraint normal.x relation right, normalised. The array is copied. *)

val of_form : Linear.t -> relation -> t
(** [of_form f relation] is the constraint f relation 0, normalised. *)

val less : Linear.t -> Linear.t -> t
(** [less f g] is the constraint f < g. *)

val at_most : Linear.t -> Linear.t -> t
(** [at_most f g] is the constraint f <= g. *)

val greater : Linear.t -> Linear.t -> t
(** [greater f g] is the constraint f > g, kept as g < f. *)

val at_least : Linear.t -> Linear.t -> t
(** [at_least f g] is the constraint f >= g, kept as g <= f. *)

val equals : Linear.t -> Linear.t -> t
(** [equals f g] is the constraint f = g. *)

(** {1 Asking} *)

val dimension : t -> int
(** The number n of variables, those that do not occur included. *)

val to_form : t -> Linear.t
(** [to_form c] is the form normal.x - right. The constraint [c] says that this form is less than, at most, or
    equal to 0. *)

val truth : t -> bool option
(** [truth c] is [Some] of the truth value of [c] if no variable occurs in it, and [None] otherwise. *)

val mem : t -> Rat.t array -> bool
(** [mem c x] is true if the point [x], of n coordinates, satisfies [c]. Another number of coordinates is a
    bug. *)

val mentions : t -> int -> bool
(** [mentions c i] is true if x{_i} has a coefficient other than 0 in [c]. *)

val first_variable : t -> int option
(** The least variable that occurs, or [None] if no variable occurs. *)

val equal : t -> t -> bool
(** [equal c d] is true if normals, relations and right sides are the same. Equal half-spaces are equal
    constraints. *)

type glance = Follows | Implies | Excludes | Unrelated

val glance : t -> t -> glance
(** [glance c d] is what two constraints show of each other without a system being solved. [Follows]: all points of
    [d] satisfy [c]. [Implies]: all points of [c] satisfy [d]. [Excludes]: no point satisfies both. [Unrelated]:
    none of these is seen. All is seen of two inequalities whose normals are multiples of each other; of equalities
    only that they are equal. Takes linear time in the dimension. *)

val compare : t -> t -> int
(** A total order: equalities first, then by normals without their common factors. Among constraints of one
    normal, the tightest comes first. *)

val same_normal : t -> t -> bool
(** [same_normal c d] is true if the normals, each divided by its common factor, are the same. Relations and
    right sides may differ. *)

(** {1 Others that it gives rise to} *)

val halves : t -> t list
(** An equality as two inequalities (<=); an inequality as the only element of a list. *)

val negation : t -> t list
(** Disjoint constraints whose union is the complement of [c]: one for an inequality, two for an equality. *)

val strict : t -> t
(** The constraint with < in place of <=. Other constraints are unchanged. *)

val closed : t -> t
(** The constraint with <= in place of <. Other constraints are unchanged. *)

val tight : t -> t
(** The equality normal.x = right: the border of the half-space. *)

val eliminate : t -> int -> by:t -> t
(** [eliminate c i ~by] is [c] without x{_i}, equivalent to [c] where the equality [by] holds. It is a bug if
    [by] is no equality or x{_i} does not occur in it. *)

val resolve : t -> t -> int -> t
(** [resolve c d i], where one of two inequalities bounds x{_i} from above and the other from below, is what
    follows for the other variables. It is a sum of positive multiples of both, strict if either is. Two bounds
    from one side are a bug. *)

val rename : t -> dimension:int -> int array -> t
(** [rename c ~dimension at] is a constraint over [dimension] variables, in which variable [at.(i)] stands for
    x{_i}. Coefficients of variables with one new number are added. *)

val substitute : t -> dimension:int -> Linear.t array -> t
(** [substitute c ~dimension forms] is [c] with [forms.(i)], a form over [dimension] variables, in place of
    x{_i}. *)
