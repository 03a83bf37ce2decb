(** Bounded polyhedra of the plane by their corners. *)

open Scc_exact
open Scc_polyhedra

type point = { x : Rat.t; y : Rat.t }

val compare : point -> point -> int
(** A total order. *)

val midpoint : point -> point -> point

val mem : Union.t -> point -> bool

val in_closure : Polyhedron.t -> point -> bool

val corners : Polyhedron.t -> point list
(** Of its closure, counter-clockwise, each once: at least three of a polygon, the two ends of a segment, or a
    point. The polyhedron is not empty. *)

val meets_at : Polyhedron.t -> point * point -> Rat.t list
(** [meets_at p (a, b)]: the parts of the way from a to b, at least 0 and at most 1, at which the segment enters
    and leaves the closure of p: [[]] if it does not come to it. *)

val along : point * point -> Rat.t -> point

val reaches_beyond : Polyhedron.t -> point -> towards:Rat.t * Rat.t -> bool
(** Whether all points near enough to the point in that direction are in the inside of the polygon. *)
