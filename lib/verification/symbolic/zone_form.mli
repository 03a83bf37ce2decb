(** Canonical forms of zones, and what compares zones by them: for searches, which have to know zones again. *)

open Scc_exact
open Scc_polyhedra
open Scc_state_sets

type t := Zone.t

val centred : t -> t
(** The zone with each state moved as a whole such that its first leaf is at the origin (rule Translation). *)

val renamed : Zone.t -> int array -> t
(** [renamed z image] is [z] with the name [image.(i)] for leaf [i] (rule Symmetry). *)

val canonical : t -> t * Linear.t array
(** [canonical z] is the set of states of [z] over its own coordinates, and the new variables as forms over the
    old ones. *)

val of_coordinates : t -> set:Polyhedron.t -> basis:int array -> Linear.t array -> t
(** [of_coordinates z ~set ~basis forms] is a zone like [z] with the [coordinates] [forms]. *)

val same_forms : t -> t -> bool
(** [same_forms a b] is true if all coordinates are the same forms over as many variables, with the same
    basis. *)

val same_kind : t -> t -> bool
(** [same_kind a b] is true if skeletons, [halted] and [arrived] are the same: the zones differ only in
    numbers. *)

val hash_kind : Zone.t -> int
(** A hash that is compatible with {!same_kind}. *)

val merged : t -> t -> t option
(** The states of two canonical zones of one kind together. [None] unless their coordinates are the same forms
    and the union of their sets is convex. *)

val sample : t -> Rat.t array
(** The [coordinates] of one of its states. *)

val has : t -> Rat.t array -> bool
(** [has z coordinates] is true if the state with these coordinates is in the canonical zone [z]. It is a quick
    test against inclusion: if the coordinates are those of a state of a zone {!included} in [z], it is true.
    The state has to be of the kind of [z]. *)

val included : t -> t -> Linear.t array option
(** [included a b], for canonical zones of one kind, is [Some forms] if each state of [a] is a state of [b].
    The forms are the variables of [b] over those of [a]. *)

val set_of : Zone.t -> Polyhedron.t
(** The set of a canonical zone without time, as a polyhedron over all coordinates. *)
