(** Obstacles made on demand, once for each ordered pair of solids. *)

open Scc_geometry

type t

val create : unit -> t
val find : t -> Solid.t -> Solid.t -> Obstacle.t
