(** Convex partitions of polygons, with holes or without, exactly. *)

val convex : Polygon.t -> int array list
(** Convex pieces by their corners, counter-clockwise, as numbers of points; the cuts between them are diagonals.
    Without holes there is no partition by diagonals into fewer. With h holes that would be too long to find (it is
    NP-hard): the shortest cuts join the holes to the outside, what is left is partitioned into the fewest
    pieces, and of those some are merged. With r reflex corners these are at most 2r + 1 pieces, where at least
    r/2 + 1 - h are needed. Angles of pieces may be straight. Time O(n^2 (n + d r)) for n corners, d of which at
    most are in sight of one of them. *)
