(** Which faces of a convex solid to keep, when only so many may stay: those without which it would grow most. *)

open Scc_geometry

val keep : most:int -> Polyhedron.ifs -> (int list, int) result
(** Of a convex closed polyhedron: faces, at most so many, whose half-spaces have a bounded intersection. One face
    goes after the other, each time one without which the solid grows least beyond the planes of faces that went
    before, near by. [Error n]: with fewer than n faces it would not be bounded, whichever goes next.

    Solid and faces are looked at as their dual: a plane at the distance d from a point inside is the point at 1/d
    in its direction, a corner is a face of the hull of these points, and the intersection is bounded as long as
    the middle is inside of that hull. When a point of it goes, the hole is closed by the hull of those beside it.
    Points of the dual are rounded and distances are floats, so that what comes out is a guess, and no more. A
    thousand faces take about a second, and four times as many about five. *)
