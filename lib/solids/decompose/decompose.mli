(** Concave solids in convex parts, exactly. *)

open Scc_exact

val parts : ?tick:(unit -> unit) -> Vec.t array list -> Cell.t list
(** Convex parts of a solid ({!Cut}, {!Union}). The list is the surface of a closed solid without
    self-intersections, as convex polygons, counter-clockwise as seen from outside. The parts have no common inner
    points, and their union is the solid. [tick] is called again and again, and may raise. *)
