(** A cache of obstacles, made on demand, once for each ordered pair of solids. *)

open Scc_geometry

type t

val create : unit -> t
(** A new, empty cache. *)

val find : t -> Solid.t -> Solid.t -> Obstacle.t
(** [find cache a b] is the obstacle of [a] and [b]. It is made at the first call for this pair of ids. *)
