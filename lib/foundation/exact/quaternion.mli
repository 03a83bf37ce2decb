(** Rotations of space as integer quaternions: exactly orthogonal, and each in one canonical form. The rotation of
    q = w + v takes x to q x q^-1; its angle is 2 atan(|v|/w). *)

type t = private { w : Z.t; x : Z.t; y : Z.t; z : Z.t }
(** The components have no common factor, and the first of w, x, y, z that is not 0 is positive. So equal rotations
    are equal quaternions. *)

val identity : t
(** The rotation by the angle 0: (1, 0, 0, 0). *)

val is_identity : t -> bool
(** [is_identity q] is true for {!identity}. *)

val make : Z.t -> Z.t -> Z.t -> Z.t -> t
(** [make w x y z] is the rotation of this quaternion, of any length but 0 (a bug otherwise). *)

val of_rationals : Rat.t -> Vec.t -> t
(** [of_rationals w v] is the rotation of the quaternion w + v, of any length but 0 (a bug otherwise). *)

val cayley : Vec.t -> t
(** [cayley u] is the rotation of 1 + u: by the angle 2 atan|u| about u (the Cayley map). *)

val mul : t -> t -> t
(** [mul p q] is the rotation by [q], followed by the rotation by [p]. *)

val inverse : t -> t
(** [inverse q] is the rotation back. *)

val norm2 : t -> Z.t
(** [norm2 q] is w^2 + x^2 + y^2 + z^2. *)

val turn : t -> Ivec.t -> Ivec.t
(** [turn q v] is the image of the vector [v] times [norm2 q], over integers. *)

val apply : t -> Vec.t -> Vec.t
(** [apply q v] is the image of the vector [v]. *)

val to_mat : t -> Mat.t
(** [to_mat q] is the rotation as an orthogonal matrix with determinant 1. *)

val round : int -> t -> t
(** [round k q], for k >= 1, is [q] scaled so that its greatest component becomes 2^k in magnitude, with components
    rounded to the nearest integers (halves away from zero). It is [q] itself if no component is greater than 2^k.
*)

val round_error : int -> Rat.t
(** [round_error k] is 2/2^k. {!round} to [k] bits moves the image of a point by at most this times the distance of
    the point from the centre. *)

val bits : t -> int
(** [bits q] is the number of bits of the greatest component. *)

val equal : t -> t -> bool
(** [equal p q] is true for equal rotations. *)

val compare : t -> t -> int
(** The lexicographic order of w, x, y, z. *)

val compare_lengths : t -> t -> int
(** The order by the magnitude of the greatest component, then by {!compare}. *)

val hash : t -> int
(** A hash that is not negative, and equal for equal rotations. *)

val to_string : t -> string
(** [to_string q] is ["(w, x, y, z)"]. *)
