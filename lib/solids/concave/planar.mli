(** Points of one plane, as seen from in front of it. Floats decide where their error allows. *)

open Scc_decompose

type axis = X | Y | Z

val axis : Plane.t -> axis
(** The axis along which points of the plane are seen best: that in which its normal is greatest. *)

val facing : Plane.t -> axis -> int
(** [facing plane axis] is 1 if what turns to the left as seen from in front of the plane does so as seen along the
    axis, -1 if it turns to the right, and 0 if the plane is parallel to the axis. *)

val turn : axis -> Homogeneous.t -> Homogeneous.t -> Homogeneous.t -> int
(** [turn axis p q r] is 1 if the way from [p] over [q] to [r] turns to the left as seen along the axis, -1 if it
    turns to the right, and 0 if it does not turn. *)

val of_face : Homogeneous.t array -> Plane.t
(** The plane of a convex polygon without straight angles, in front of which it is counter-clockwise. *)

val share : Plane.t -> Homogeneous.t array -> Homogeneous.t array -> bool
(** [share plane p q] is true if two convex polygons, both counter-clockwise, have an area in common. *)

val holds : Plane.t -> Homogeneous.t array -> Homogeneous.t -> bool
(** [holds plane p x] is true if the point [x] is in a convex polygon, which is counter-clockwise. *)
