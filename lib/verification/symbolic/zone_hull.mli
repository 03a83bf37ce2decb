(** Zones around others of their kind, for proofs (rule Invariants). All of them are canonical, and do not keep
    time. *)

val join : Instant.context -> Zone.t -> Zone.t -> Zone.t
(** A zone that has all states of two of one kind: it is as large as the planes that bound it allow
    ({!Scc_polyhedra.Hull.join}). Besides those of the borders of both these are in the directions of the
    coordinates, and of how far two places along an axis, or two ages, are from each other: the order of bodies is
    of this kind, and which delay is over first. What is on one side of a plane of an obstacle in both stays
    there. *)

val widen : Instant.context -> Zone.t -> Zone.t -> Zone.t
(** [widen c old joined]: with fewer borders, so that a sequence in which each is widened by a {!join} with it
    comes to rest; but up to planes of obstacles (N. Halbwachs, Y.-E. Proy and P. Roumanoff, {e Verification of
    real-time systems using linear relation analysis}, 1997). *)

val meet : Zone.t -> Zone.t -> Zone.t
(** All states of the first that are in the second, which has some. *)
