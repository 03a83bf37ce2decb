(** Oriented planes: the half-space behind one is where n . x <= n . p, for its normal n. *)

open Scc_exact

type t = private { a : Z.t; b : Z.t; c : Z.t; d : Z.t }  (** a x + b y + c z <= d, without a common divisor *)

val make : Ivec.t -> Place.t -> t
(** With that normal, not zero, through the point. *)

val through : Place.t -> Place.t -> Place.t -> t option
(** They run counter-clockwise as seen from in front. [None] if they are on a line. *)

val opposite : t -> t
val equal : t -> t -> bool
val hash : t -> int

val height : t -> Place.t -> Z.t
(** A number with the sign of the side on which the point is: positive in front, 0 on the plane. *)

val side : t -> Place.t -> int
