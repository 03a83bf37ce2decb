(** What is asked of the obstacle A - B of two solids, in floats: B stands at the offset r and moves at the
    velocity w, as seen from A. Everything is about the offset: a point of the obstacle is p = a - b - r, and the
    line runs from the origin along w. *)

type t = private {
  a : Solid.t;
  b : Solid.t;
  offset : Shadow.floats;
  velocity : Shadow.floats;
  bound : float;  (** no coordinate of a vertex of A, of B or of r is greater: the sum of the three bounds *)
}

val make : Solid.t -> Solid.t -> Shadow.floats -> Shadow.floats -> t option
(** [make a b r w], with the floats of r and w; [None] where floats would overflow or the solids are too thin for
    them. *)

val bound_on : Solid.t -> Solid.t -> Shadow.floats -> float
(** The bound for the offset r. *)
