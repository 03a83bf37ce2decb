(** State predicates over the tuples of {!Network_lts}. *)

open Scc_ctl
open Scc_property

val make : Network_lts.context -> Property.prop -> On_the_fly.predicate
(** In a state by the components of the tuple, each of which is looked at once where that is worth it. Predicates
    that may change while time passes undisturbed ({!Formula.steady}) also along the trajectory. *)
