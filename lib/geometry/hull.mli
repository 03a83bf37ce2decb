(** Convex hulls of points, exactly. *)

open Scc_exact

val triangles : Vec.t array -> int array list option
(** The surface of the hull as triangles of indices, counter-clockwise from outside; several of one plane make a
    face. Points may coincide. [None] when all are in one plane. Time in proportion to the number of points times
    that of triangles. *)
