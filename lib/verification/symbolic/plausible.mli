open Scc_state_sets

(** The states of a zone that may be reachable, if the zone is larger than that. In all states of all runs rule
    WellFormed holds, delays and split clocks are not over, and parameters are in their ranges. *)

val pieces : Instant.context -> Zone.t -> Zone.t list
(** Disjoint parts of the zone that contain all its states that may be reachable; none is empty. Planes that
    keep bodies apart divide them. *)
