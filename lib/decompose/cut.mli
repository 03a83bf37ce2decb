(** Space, cut by planes of faces of a solid until in each cell the solid is convex. *)

val parts : tick:(unit -> unit) -> Cell.t -> (Plane.t * Place.t array) list -> Cell.t list
(** The surface of a closed solid without self-intersections as convex polygons, each with its plane, in front
    of which is the outside; all of it inside the box. The cells are convex, have no inner point in common,
    and are together the solid.

    A cell holds those pieces of the surface that are not in its walls. It is cut by the plane of a piece P in
    front of which there are others: what is behind is inside the solid next to P, and what is in front is
    outside, so that a half without pieces is wholly inside or outside. Where no piece is in front of the
    plane of another, the solid in the cell is what is behind them all: on the plane of P that is a convex
    polygon, of which the pieces of this plane are all; for the surface goes on at the edge of a piece in the
    plane of another one, and has nothing in front of that. Each cut takes a plane out of both halves, so
    there is an end. [tick] is called at each cell. *)
