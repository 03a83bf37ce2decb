(** Bounds on the speed of two turning solids as seen from each other: short upper bounds, computed exactly. *)

open Scc_exact
open Scc_geometry

val reach : Solid.t -> Vec.t -> Rat.t
(** [reach solid arm] is a bound on the distance of all points of a solid from a centre, when its centroid is
    at [arm] from that centre. *)

val bound : Motion.t -> Motion.t -> Rat.t
(** The bound {!Cast.speed_bound}. *)

val grid : Motion.t -> Motion.t -> resolution:Rat.t -> int
(** The grid {!Cast.grid}. *)
