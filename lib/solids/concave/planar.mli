(** Points of one plane, as seen from in front of it. Floats decide where their error allows. *)

open Scc_decompose

val of_face : Homogeneous.t array -> Plane.t
(** The plane of a convex polygon without straight angles, in front of which it is counter-clockwise. *)

val share : Plane.t -> Homogeneous.t array -> Homogeneous.t array -> bool
(** [share plane p q] is true if two convex polygons, both counter-clockwise, have an area in common. *)

val holds : Plane.t -> Homogeneous.t array -> Homogeneous.t -> bool
(** [holds plane p x] is true if the point [x] is in a convex polygon, which is counter-clockwise. *)
