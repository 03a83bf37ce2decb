(** Affine maps of the plane, over the rationals: those of SVG's transforms. *)

open Scc_exact

type point = Rat.t * Rat.t

type t = { a : Rat.t; b : Rat.t; c : Rat.t; d : Rat.t; e : Rat.t; f : Rat.t }
(** (x, y) becomes (a x + c y + e, b x + d y + f). *)

val identity : t
val apply : t -> point -> point

val compose : t -> t -> t
(** [compose m n] applies [n] first. *)

val scaling : Rat.t -> Rat.t -> t
val translation : Rat.t -> Rat.t -> t

val cos_sin : Rat.t -> point
(** Of an angle in degrees, each within 2{^-50}, and exact for multiples of 90 degrees. *)

val rotation : Rat.t -> t
(** By degrees. *)

val skewing : [ `X | `Y ] -> Rat.t -> t option
(** By degrees; [None] for right angles. *)

val stretch : t -> Rat.t
(** No vector gets longer than this times its length. *)
