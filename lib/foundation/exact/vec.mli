(** Rational vectors of space. *)

type t = { x : Rat.t; y : Rat.t; z : Rat.t }

type axis = X | Y | Z

val component : axis -> t -> Rat.t
val unit : axis -> t
val zero : t
val make : Rat.t -> Rat.t -> Rat.t -> t
val of_ints : int -> int -> int -> t
val add : t -> t -> t
val sub : t -> t -> t
val neg : t -> t
val scale : Rat.t -> t -> t

val axpy : Rat.t -> t -> t -> t
(** [axpy a x y] is a x + y. *)

val dot : t -> t -> Rat.t
val cross : t -> t -> t

val norm2 : t -> Rat.t
(** The squared length. *)

val is_zero : t -> bool
val equal : t -> t -> bool

val compare : t -> t -> int
(** Lexicographic. *)

val bits : t -> int
(** Of the longest component ({!Rat.bits}). *)

val hash : t -> int

val to_string : t -> string
(** ["(x, y, z)"]. *)

val in_short : t -> string
(** The same, for people; rounded if it would be longer than a line, and then it says [about]. *)
