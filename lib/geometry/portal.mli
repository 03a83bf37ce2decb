(** Portals: where a line enters the obstacle A - B of two solids, or a plane between the two, sought in
    floats. Which vertices and which direction are found is a guess and nothing more: {!Certificate} proves it,
    over integers where floats cannot, and all that a wrong guess can cost is time. What proofs rely on is this:
    a point is where {!place} puts it for its two vertices; the offset stays as it was made, and so do the
    velocity in a cast and the centre.

    Everything is about the offset r at which B stands: a point of the obstacle is p = a - b - r, and the line
    runs from the origin along w. *)

type t = private {
  a : Solid.t;
  b : Solid.t;
  x : float array;  (** vectors, three floats each, at the places below *)
  va : int array;  (** the vertex of A behind each of the points 0 to 5 *)
  vb : int array;  (** the vertex of B *)
  bound : float;  (** no coordinate of a vertex of A, of B or of r is greater: the sum of the three bounds *)
  mutable hasty : bool;  (** a plane that seems to separate ends the search *)
}

val direction : int
(** The last direction in which a support was taken. *)

val velocity : int
val centre : int
(** A point strictly inside the obstacle. *)

val point : int -> int
(** The place of the points: 0 to 2 are the portal, 3 the last support, 4 and 5 the edge (below). *)

val bound_on : Solid.t -> Solid.t -> Shadow.floats -> float
(** The bound of a portal for the offset r. *)

val make : Solid.t -> Solid.t -> Shadow.floats -> Shadow.floats -> t option
(** [make a b r w], with the floats of r and w; [None] where floats would overflow or the solids are too
    thin for them. *)

val place : t -> int -> int -> int -> unit
(** [place s k i j]: puts the point of vertex i of A and vertex j of B at [k]. *)

val support : t -> int -> unit
(** [support s k]: puts the point of the obstacle that is highest in the {!direction} at [k]. *)

type search =
  | Apart  (** the {!direction} seems to separate, and to be orthogonal to the line in a cast *)
  | Beside  (** the line seems to pass along or outside of points 4 and 5, an edge of the silhouette *)
  | Through
  (** the line seems to enter through the portal, which carries a facet; it passes between the centre
      and points 4 and 5 *)
  | Inside  (** the origin seems to be between the centre and the portal (in {!locate} only) *)
  | Lost

type guess = {
  cast : t -> hasty:bool -> search;
  (** follows the line from behind to where it enters the obstacle: [Apart] (only if [hasty]), [Beside],
      [Through] or [Lost] *)
  through : t -> search;  (** goes on from [Beside], the edge being no edge of the silhouette *)
  locate : t -> hasty:bool -> search;
  (** seeks the origin: [Apart] (only if [hasty]), [Inside], the portal that carries the facet towards it
      ([Through]), or [Lost]; the velocity is lost *)
}

val guess : guess
(** Portal ray-shooting. *)
