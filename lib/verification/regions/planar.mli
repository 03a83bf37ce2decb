(** Bounded polyhedra of the plane by their corners. *)

open Scc_exact
open Scc_polyhedra

type point = { x : Rat.t; y : Rat.t }

val compare : point -> point -> int
(** A total order: by x, then by y. *)

val midpoint : point -> point -> point
(** The point halfway between two points. *)

val mem : Union.t -> point -> bool
(** [mem u p] is true if the point is in the set. *)

val in_closure : Polyhedron.t -> point -> bool
(** [in_closure p point] is true if the point is in the closure of the polyhedron. *)

val corners : Polyhedron.t -> point list
(** The corners of the closure of a polyhedron that is not empty, counter-clockwise, each once. A polygon has
    at least three corners, a segment its two ends, and a point itself. *)

val meets_at : Polyhedron.t -> point * point -> Rat.t list
(** [meets_at p (a, b)] are the parameters, from 0 at a to 1 at b, at which the segment enters and leaves the
    closure of [p]. [[]] if it does not meet it. *)

val along : point * point -> Rat.t -> point
(** [along (a, b) t] is the point a + t (b - a). *)

val reaches_beyond : Polyhedron.t -> point -> towards:Rat.t * Rat.t -> bool
(** [reaches_beyond p point ~towards] is true if all points near enough to [point] in the direction [towards]
    are in the interior of the polygon. *)
