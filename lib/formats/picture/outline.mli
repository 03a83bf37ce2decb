(** The border of a region that is given in disjoint convex pieces. *)

open Scc_exact

val loops : Convex.t list -> Ivec.t list list
(** Closed polygons with the region to their left: outer borders counterclockwise, holes clockwise. Borders
    between two pieces are removed, so that no seams are visible. *)
