(** Rule WellFormed on sets of states: conditions that hold in each state of a run. *)

open Scc_polyhedra

val convex : Zone_parts.context -> Zone.t -> Polyhedron.t
(** [convex c z] are the states of [z] for which the following holds. The parameters are in their ranges. Ages and
    split clocks are not negative, and no delay and no split clock is over. The features touch that bonds join. *)

val overlap : Zone_parts.context -> Zone_parts.part * Zone_parts.part -> Constraint.t list
(** The two parts interpenetrate where all of these hold. *)

val apart : Zone_parts.context -> Zone.t -> Polyhedron.t list
(** Disjoint regions, none empty, whose union are the states of the zone in which no two leaves interpenetrate. *)
