(** The fewest convex pieces that diagonals cut a polygon into: dynamic programming, as Greene's (1983) and Keil's
    (1985) algorithms. *)

val pieces : Cycle.t -> int array list
(** Each by its corners, counter-clockwise, as numbers of points; no two of their angles are one, and angles may be
    straight. No partition by diagonals between corners of the cycle has fewer. For a cycle that is a polygon
    without holes this is the optimum. *)
