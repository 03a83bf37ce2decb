(** Two solids that move and turn, in floats, with bounds on the errors: what the search for their contact works
    with. World axes; B's centre of turning is seen from that of A; times count from now. *)

open Scc_geometry

(** How a solid is turned at an instant: the rotation that takes {!Shadow} coordinates to the world, where the
    reference point is as seen from the centre of turning, and the angular velocity. *)
type turn = {
  mutable xx : float;
  mutable xy : float;
  mutable xz : float;
  mutable yx : float;
  mutable yy : float;
  mutable yz : float;
  mutable zx : float;
  mutable zy : float;
  mutable zz : float;
  mutable ex : float;
  mutable ey : float;
  mutable ez : float;
  mutable wx : float;
  mutable wy : float;
  mutable wz : float;
}

(** Upper bounds of lengths, but for [since]. *)
type sizes = {
  since : float;
  spin : float;
  reach : float;  (** from the centre of turning to a point of the solid *)
  extent : float;  (** |arm| and the distance of a point of the solid from its reference point *)
}

type body = {
  solid : Solid.t;
  turning : bool;
  spin : Shadow.floats;
  start : turn;  (** at the start of the turn *)
  now : turn;  (** at the instant {!move}d to *)
  sizes : sizes;
}

(** The same for both. *)
type scales = {
  length : float;  (** S of the error bounds below *)
  whirl : float;  (** neither |spin| is greater *)
  end_ : float;  (** the span, rounded up *)
}

type t = {
  a : body;
  b : body;
  offset : Shadow.floats;  (** of B's centre, at time 0 *)
  velocity : Shadow.floats;  (** of B less that of A *)
  here : float array;  (** the offset at the instant {!move}d to: three coordinates *)
  scales : scales;
}

val make : Motion.t -> Motion.t -> float -> t option
(** [make a b span]: [None] when coordinates are too great, too small or too fine for the bounds to hold. *)

val move : t -> float -> unit
(** To an instant from 0 to the span. *)

val apart_forever : t -> bool
(** Whether the balls that the solids turn in are seen to be apart throughout the span. *)

val epsilon : float
(** Coordinates of a vertex of B less those of one of A, at the instant moved to, are within [epsilon] S of the
    exact ones; so is the product of that difference with a vector of a length <= 1. *)
