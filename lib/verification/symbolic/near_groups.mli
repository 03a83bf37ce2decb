(** Groups of processes that may touch each other in some states of a region, directly or through others (rule
    Order). Within an instant nothing moves, so events of one group do not influence the others. *)

open Scc_polyhedra
open Scc_state_sets

type t

val make : Instant.context -> Zone.t -> Polyhedron.t -> t
(** [make c z region] are the groups of the processes of [z] in the states of [region]. *)

val of_leaf : t -> int -> int
(** The number of the group of a leaf that is there. *)

val hidden : t -> visible:(int -> bool) -> int -> bool
(** [hidden t ~visible group] is true if no leaf of the group is visible. *)
