open Scc_state_sets

(** Zones around others of their kind, for proofs (rule Invariants). All of them are canonical, and do not keep
    time. *)

val join : Instant.context -> Zone.t -> Zone.t -> Zone.t
(** [join c a b] is a zone that contains all states of two zones of one kind. It is as small as the planes
    permit that may bound it ({!Scc_polyhedra.Hull.join}). Their directions are those of the borders of both
    and those of the coordinates. Differences of two places along an axis, or of two ages, are directions, too.
    So the order of bodies, and of the ends of delays, is kept. Planes of obstacles that have both zones on one
    side bound the result as well. *)

val widen : Instant.context -> Zone.t -> Zone.t -> Zone.t
(** [widen c old joined] is [joined] with fewer borders, so that a sequence becomes constant in which each zone
    is widened by a {!join} with it. Planes of obstacles are kept (N. Halbwachs, Y.-E. Proy and P. Roumanoff,
    {e Verification of real-time systems using linear relation analysis}, 1997). *)

val meet : Zone.t -> Zone.t -> Zone.t
(** [meet a b] are all states of [a] that are in [b]; there are some. *)
