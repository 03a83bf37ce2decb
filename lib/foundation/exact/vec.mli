(** Rational vectors of space. *)

type t = { x : Rat.t; y : Rat.t; z : Rat.t }

type axis = X | Y | Z

val component : axis -> t -> Rat.t
(** [component axis v] is the coordinate of [v] along the axis. *)

val unit : axis -> t
(** [unit axis] is the vector of length 1 along the axis. *)

val zero : t
(** (0, 0, 0). *)

val make : Rat.t -> Rat.t -> Rat.t -> t
(** [make x y z] is the vector (x, y, z). *)

val of_ints : int -> int -> int -> t
(** [of_ints x y z] is the vector (x, y, z). *)

val add : t -> t -> t
(** [add a b] is a + b. *)

val sub : t -> t -> t
(** [sub a b] is a - b. *)

val neg : t -> t
(** [neg a] is -a. *)

val scale : Rat.t -> t -> t
(** [scale k a] is k a. *)

val middle : t -> t -> t
(** [middle a b] is (a + b)/2. *)

val axpy : Rat.t -> t -> t -> t
(** [axpy a x y] is a x + y. *)

val dot : t -> t -> Rat.t
(** [dot a b] is the scalar product a . b. *)

val cross : t -> t -> t
(** [cross a b] is the cross product a x b. *)

val norm2 : t -> Rat.t
(** [norm2 a] is the squared length of [a]. *)

val is_zero : t -> bool
(** [is_zero a] is true for the zero vector. *)

val equal : t -> t -> bool
(** [equal a b] is true if all coordinates are equal. *)

val compare : t -> t -> int
(** The lexicographic order of the coordinates. *)

val bits : t -> int
(** [bits a] is the greatest {!Rat.bits} of the three coordinates. *)

val hash : t -> int
(** A hash that is equal for equal vectors. *)

val to_string : t -> string
(** [to_string a] is ["(x, y, z)"], with exact rational coordinates. *)

val in_short : ?most:int -> t -> string
(** [in_short a] is {!to_string} if that has at most [most] bytes, 120 by default. Otherwise it is
    ["about (x, y, z)"], with coordinates rounded to 6 digits. *)
