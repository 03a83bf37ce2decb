(** A choice of the faces of a convex solid to keep, when their number is limited: those without which it would
    grow most. *)

open Scc_geometry

val keep : most:int -> Polyhedron.ifs -> (int list, int) result
(** [keep ~most set] are at most [most] faces of a convex closed polyhedron whose half-spaces have a bounded
    intersection. Faces are removed one after the other. Each time it is the face without which the solid grows
    least beyond the planes of removed faces near by. [Error n]: with fewer than n faces it would not be
    bounded, whichever goes next.

    Solid and faces are represented by their dual. A plane at the distance d from a point inside is the point
    at 1/d in its direction. A corner is a face of the hull of these points. The intersection is bounded as
    long as the middle is inside that hull. When a point is removed, the hole is closed by the hull of those
    beside it. Points of the dual are rounded and distances are floats, so the result is a guess. A thousand
    faces take about a second, and four times as many about five. *)
