(** Where the points of a view are on the paper: in pixels, y downwards. *)

open Scc_exact

type t = private {
  width : int;  (** of the drawing, with its margin *)
  height : int;
  unit_length : Rat.t;  (** in pixels *)
  place : Ivec.t -> Rat.t * Rat.t;  (** of a point as in {!Convex} *)
}

val make : Camera.t -> width:int -> margin:int -> top:int -> Ivec.t list -> t
(** All points, of which there is at least one, are within the margins, as large as they can be: as wide as it,
    and no higher than four thirds of that. [top] is kept free above. *)

val bar : t -> most:int -> Rat.t
(** A round length, 1, 2 or 5 times a power of ten, that takes at most so many pixels, and the greatest such. *)
