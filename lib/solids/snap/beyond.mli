(** How far one convex solid goes beyond another that is inside of it, exactly. *)

open Scc_exact
open Scc_geometry

val distance2 : hull:Polyhedron.ifs -> Polyhedron.ifs -> Rat.t
(** The square of the greatest distance of a point of the outer one from the hull. Distance from a convex set is a
    convex function, so that this is at a corner of the outer one. Where the hull is nearest to a corner x is
    guessed in floats; a point y of it is nearest, which is tried exactly, when (x - y) . (v - y) <= 0 for all
    corners v of the hull. *)
