(** How fast two turning solids can move as seen from each other: short numbers on the safe side, found exactly. *)

open Scc_exact
open Scc_geometry

val length : Vec.t -> Rat.t
(** The length of a vector, rounded up to ten bits or so. *)

val reach : Solid.t -> Vec.t -> Rat.t
(** [reach solid arm]: no point of a solid with its centroid at [arm] from a centre is farther from that centre. *)

val bound : Motion.t -> Motion.t -> Rat.t
(** See {!Cast.speed_bound}. *)

val grid : Motion.t -> Motion.t -> resolution:Rat.t -> int
(** See {!Cast.grid}. *)
