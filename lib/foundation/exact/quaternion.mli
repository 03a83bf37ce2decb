(** Rotations of space as integer quaternions: exactly orthogonal, and in one form each. The rotation of q = w + v
    takes x to q x q^-1; its angle is 2 atan(|v|/w). *)

type t = private { w : Z.t; x : Z.t; y : Z.t; z : Z.t }
(** Not zero, without a common factor, and the first of w, x, y, z that is not 0 is positive: equal rotations are
    equal quaternions. *)

val identity : t
val is_identity : t -> bool

val make : Z.t -> Z.t -> Z.t -> Z.t -> t
(** The rotation of the quaternion w, x, y, z, of any length but 0 (a bug otherwise). *)

val of_rationals : Rat.t -> Vec.t -> t
(** [of_rationals w v], not both zero. *)

val cayley : Vec.t -> t
(** The rotation of 1 + u: by the angle 2 atan|u| about u (the Cayley map). *)

val mul : t -> t -> t
(** [mul p q] turns by [q] first. *)

val inverse : t -> t

val norm2 : t -> Z.t
(** w^2 + x^2 + y^2 + z^2. *)

val turn : t -> Ivec.t -> Ivec.t
(** The image of a vector, times {!norm2}. *)

val apply : t -> Vec.t -> Vec.t
(** The image of a vector. *)

val to_mat : t -> Mat.t

val round : int -> t -> t
(** [round k q], for k >= 1: the components in proportion to the greatest, which becomes 2^k, to the nearest
    integers (of two, the one farther from zero); [q] itself when no component is greater than 2^k. *)

val round_error : int -> Rat.t
(** [round_error k]: by at most this times its distance from the centre a point is moved when a quaternion is
    {!round}ed to k bits. *)

val bits : t -> int
(** Of its longest component: how much it has grown. *)

val equal : t -> t -> bool
val compare : t -> t -> int

val compare_lengths : t -> t -> int
(** By the greatest component first. *)

val hash : t -> int

val to_string : t -> string
(** ["(w, x, y, z)"]. *)
