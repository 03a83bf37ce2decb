(** Convex hulls of points, exactly. *)

open Scc_exact

val triangles : Vec.t array -> int array list option
(** The surface of the hull as triangles of indices, counter-clockwise from outside, in no fixed order. A face
    of the hull may consist of several triangles. If points coincide, the first of them is used. [None] if all
    points are in one plane. Near linear in the number of points, except for adversarial input. *)
