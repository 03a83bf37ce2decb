(** How fast two turning solids can move as seen from each other: short numbers on the safe side, found exactly. *)

open Scc_exact

val bound : Motion.t -> Motion.t -> Rat.t
(** See {!Cast.speed_bound}. *)

val grid : Motion.t -> Motion.t -> resolution:Rat.t -> int
(** See {!Cast.grid}. *)
