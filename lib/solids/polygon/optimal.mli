(** The fewest convex pieces into which diagonals cut a polygon: dynamic programming, as in the algorithms of
    Greene (1983) and Keil (1985). *)

val pieces : Cycle.t -> int array list
(** The pieces by their corners, counter-clockwise, as numbers of points. Angles may be straight. No partition
    by diagonals between corners of the cycle has fewer pieces. For the cycle of a polygon without holes this
    is the optimum. *)
