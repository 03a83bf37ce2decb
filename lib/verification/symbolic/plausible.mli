(** What of a zone may be reached at all, where it is larger than what is: rule WellFormed holds in all states of
    all runs, delays and split clocks are not over, and parameters are in their ranges. *)

val pieces : Instant.context -> Zone.t -> Zone.t list
(** Disjoint parts of the zone that have all its states that may be reached; none is empty. They differ by the
    planes that keep bodies apart. *)
