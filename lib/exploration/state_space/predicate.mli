(** State predicates over the tuples of {!Network_lts}. *)

open Scc_ctl
open Scc_property

val make : Network_lts.context -> Property.prop -> On_the_fly.predicate
(** [make c p] is [p] as a predicate of tuples. In a state it is evaluated by the components of the tuple, with a
    cache for each where that is worth it. If [p] may change while time passes ([Formula.steady]), it is a
    predicate of trajectories as well. *)
