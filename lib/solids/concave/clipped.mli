(** Convex polygons, clipped. *)

open Scc_exact

val clip : (Vec.t -> Rat.t) -> Vec.t array -> Vec.t array
(** [clip height polygon] is what the convex polygon has on the closed side of a plane on which the affine function
    [height] is not negative. It may be a segment, a point or empty. *)

val common : Vec.t -> Vec.t array -> Vec.t array -> Vec.t array
(** [common n one other] is what both polygons have in common. They are as for {!difference}, and have a common
    inner point. *)

val difference : Vec.t -> Vec.t array -> Vec.t array -> Vec.t array list
(** [difference n one other] are convex polygons with positive areas whose union is the closure of [one] without
    [other]. Both are convex, in one plane with the normal [n], and counter-clockwise about it. *)
