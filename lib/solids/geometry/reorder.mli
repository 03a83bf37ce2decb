(** The right order of the corners of faces that list them in another one, so that their sides cross. *)

open Scc_exact

val repair : Ivec.t array -> int array array -> int list -> int array array
(** [repair points faces wrong] is the faces, in which each face of [wrong] has its corners in the order in which
    they go around a strictly convex polygon. It keeps its corners as they are if they are not all corners of one
    polygon, or if no more of its sides are then sides of other faces. The order is counterclockwise, seen from
    beyond the face from the mean of all corners. Other faces are physically equal to those given. *)
