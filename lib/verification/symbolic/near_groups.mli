(** Processes that may touch each other in some states of a region, directly or through others, are a group (rule
    Order): within an instant nothing moves, so that what one group does is nothing to the others. *)

open Scc_polyhedra

type t

val make : Instant.context -> Zone.t -> Polyhedron.t -> t

val of_leaf : t -> int -> int
(** The number of the group of a leaf that is there. *)

val hidden : t -> visible:(int -> bool) -> int -> bool
(** Of a group: none of its leaves is visible. *)
