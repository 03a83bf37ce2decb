(** The border of a region that is given in disjoint convex pieces. *)

open Scc_exact

val loops : Convex.t list -> Ivec.t list list
(** Closed polygons, the region to their left: its outside counterclockwise, holes clockwise. What the pieces
    have in common is gone, so that no seams are seen where they meet. *)
