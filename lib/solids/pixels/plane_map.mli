(** Affine maps of the plane, over the rationals: those of SVG's transforms. *)

open Scc_exact

type point = Rat.t * Rat.t

type t = { a : Rat.t; b : Rat.t; c : Rat.t; d : Rat.t; e : Rat.t; f : Rat.t }
(** (x, y) becomes (a x + c y + e, b x + d y + f). *)

val identity : t
(** The map that leaves each point where it is. *)

val apply : t -> point -> point
(** [apply m p] is the image of the point [p]. *)

val is_identity : t -> bool
(** [is_identity m] is true if [m] leaves each point where it is. *)

val is_invertible : t -> bool
(** [is_invertible m] is true if [m] maps different points to different ones. *)

val compose : t -> t -> t
(** [compose m n] is the map that applies [n], then [m]. *)

val scaling : Rat.t -> Rat.t -> t
(** [scaling x y] multiplies the coordinates by [x] and [y]. *)

val translation : Rat.t -> Rat.t -> t
(** [translation x y] adds [x] and [y] to the coordinates. *)

val rotation : Rat.t -> t
(** The rotation by an angle in degrees, with the numbers of {!Scc_exact.Angle.cos_sin}. It takes the x axis
    towards the y axis. *)

val skewing : [ `X | `Y ] -> Rat.t -> t option
(** The skewing along an axis by an angle in degrees; [None] for right angles. *)

val stretch : t -> Rat.t
(** A bound on the factor by which the map lengthens any vector: the sum of the absolute values of a, b, c and
    d. *)
