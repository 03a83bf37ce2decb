(** The exact distance by which a convex solid goes beyond another one inside it. *)

open Scc_exact
open Scc_geometry

val distance2 : hull:Polyhedron.ifs -> Polyhedron.ifs -> Rat.t
(** [distance2 ~hull outer] is the square of the greatest distance of a point of [outer] from the hull. The
    distance from a convex set is a convex function, so the greatest distance is at a corner of [outer]. The
    point of the hull nearest to a corner x is guessed in floats. A point y of the hull is nearest, which is
    checked exactly, if (x - y) . (v - y) <= 0 for all corners v of the hull. *)
