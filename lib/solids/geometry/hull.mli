(** Convex hulls of points, exactly. *)

open Scc_exact

val triangles : Vec.t array -> int array list option
(** The surface of the hull as triangles of indices, counter-clockwise from outside, in no order to rely on;
    several of one plane make a face. Points may coincide: the first of them is meant. [None] when all are in one
    plane. Near linear in the number of points, unless they are made to be slow. *)
