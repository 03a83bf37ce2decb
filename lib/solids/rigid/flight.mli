(** Two solids that move and turn, in floats, with bounds on the errors, for the search for their contact.
    World axes; the centre of turning of B is seen from that of A; times count from now. *)

open Scc_geometry

(** The turn of a solid at an instant. [xx] to [zz] are the rotation from [Shadow] coordinates to the world,
    by rows. [ex], [ey], [ez] are the reference point as seen from the centre of turning. [wx], [wy], [wz] are
    the angular velocity. *)
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

(** Upper bounds of lengths, except for [since]. *)
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

(** Bounds for both solids together. *)
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
(** [make a b span] is the flight of two motions over times from 0 to [span]. [None] if coordinates are too
    great, too small or too fine for the bounds to hold. *)

val move : t -> float -> unit
(** [move t s] sets [now] and [here] to the instant [s], from 0 to the span. *)

val apart_forever : t -> bool
(** [apart_forever t] is true if the balls that the solids turn in are proved to be apart throughout the
    span. *)

val epsilon : float
(** The relative error bound. Coordinates of a vertex of B less those of one of A, at the current instant, are
    within [epsilon] S of the exact ones. So is the product of that difference with a vector of length at most
    1. *)
