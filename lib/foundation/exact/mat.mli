(** Rational 3 x 3 matrices, by rows. *)

type t = { r0 : Vec.t; r1 : Vec.t; r2 : Vec.t }

val identity : t
val make : Vec.t -> Vec.t -> Vec.t -> t

val diagonal : Vec.t -> t
(** The scaling by a factor for each axis. *)

val of_quaternion : Rat.t * Rat.t * Rat.t * Rat.t -> t option
(** [of_quaternion (w, x, y, z)] is the rotation of the quaternion, which need not be a unit: exactly
    orthogonal with determinant 1. [None] for the zero quaternion. *)

val apply : t -> Vec.t -> Vec.t
val mul : t -> t -> t
val add : t -> t -> t
val scale : Rat.t -> t -> t
val transpose : t -> t
val det : t -> Rat.t

val inverse : t -> t option
(** [None] when the determinant is zero. *)

val equal : t -> t -> bool
val compare : t -> t -> int
val hash : t -> int
