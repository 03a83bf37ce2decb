(** Convex partitions of polygons, with holes or without, exactly. *)

val convex : Polygon.t -> int array list
(** Convex pieces by their corners, counter-clockwise, as numbers of points; the cuts between them are
    diagonals. Without holes no partition by diagonals has fewer pieces. With h holes the optimum would take
    too long (it is NP-hard). Then the shortest cuts join the holes to the outside, the rest is partitioned
    into the fewest pieces, and some pieces are merged. With r reflex corners these are at most 2r + 1 pieces,
    where at least r/2 + 1 - h are needed. Angles of pieces may be straight. Time O(n^2 (n + d r)) for n
    corners, where at most d are visible from one of them. *)

val quick : Polygon.t -> int array list
(** [quick p] are convex pieces as those of {!convex}. Of more than 64 corners without holes they are unions of
    triangles of {!Ears}: at most four times as many as needed, in far less time. *)
