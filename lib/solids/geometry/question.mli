(** A question about the obstacle A - B of two solids, in floats. B is at the offset r and moves at the
    velocity w, as seen from A. Coordinates are relative to the offset: a point of the obstacle is p = a - b -
    r, and the line runs from the origin along w. *)

type t = private {
  a : Solid.t;
  b : Solid.t;
  offset : Shadow.floats;
  velocity : Shadow.floats;
  bound : float;  (** no coordinate of a vertex of A, of B or of r is greater: the sum of the three bounds *)
}

val make : Solid.t -> Solid.t -> Shadow.floats -> Shadow.floats -> t option
(** [make a b r w] is the question with the floats of r and w. [None] if floats would overflow or the solids
    are too thin for them. *)

val bound_on : Solid.t -> Solid.t -> Shadow.floats -> float
(** [bound_on a b r] is a bound on all coordinates at offset r: the sum of those on the coordinates of A, of B
    and of r. *)
