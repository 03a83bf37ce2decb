(** Rational 3 x 3 matrices, by rows. *)

type t = { r0 : Vec.t; r1 : Vec.t; r2 : Vec.t }

val identity : t
(** The unit matrix. *)

val make : Vec.t -> Vec.t -> Vec.t -> t
(** [make r0 r1 r2] is the matrix with these rows. *)

val diagonal : Vec.t -> t
(** [diagonal d] is the scaling by the factor [d.x] along the x axis, [d.y] along y and [d.z] along z. *)

val of_quaternion : Rat.t * Rat.t * Rat.t * Rat.t -> t option
(** [of_quaternion (w, x, y, z)] is the rotation of the quaternion, which need not be a unit: exactly
    orthogonal with determinant 1. [None] for the zero quaternion. *)

val apply : t -> Vec.t -> Vec.t
(** [apply m v] is the product m v with a column vector. *)

val mul : t -> t -> t
(** [mul a b] is the matrix product a b: as maps, [b] comes first. *)

val add : t -> t -> t
(** [add a b] is a + b. *)

val scale : Rat.t -> t -> t
(** [scale k a] is k a. *)

val transpose : t -> t
(** [transpose m] has the columns of [m] as its rows. *)

val det : t -> Rat.t
(** [det m] is the determinant of [m]. *)

val inverse : t -> t option
(** [inverse m] is the inverse matrix; [None] if the determinant is 0. *)

val equal : t -> t -> bool
(** [equal a b] is true if all entries are equal. *)

val hash : t -> int
(** A hash that is equal for equal matrices. *)
