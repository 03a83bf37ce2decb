(** The right order of the corners of faces that list them in another one, so that their sides cross. *)

open Scc_exact

val order : Ivec.t array -> int array -> int array option
(** [order points corners] is the tuple from the same first corner on, in the order in which it goes around a
    strictly convex polygon, if all corners are corners of one. It runs either way round. The corners, at least
    three, lie in a plane. *)

val repair : Ivec.t array -> int array array -> int list -> int array array
(** [repair points faces wrong] is the faces, in which each face of [wrong] has its corners in {!order}, if more of
    its sides are then sides of other faces than before. It runs counterclockwise seen from beyond it from the mean
    of all corners. Other faces are physically equal to those given. *)
