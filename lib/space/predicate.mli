(** State predicates over the tuples of {!Network_lts}. *)

open Scc_ctl
open Scc_property

val make : Network_lts.context -> Property.prop -> On_the_fly.predicate
(** Predicates that do not change while time passes undisturbed are judged by the components of a state, each of
    which is looked at once; the others along the trajectory (see {!Trajectory}). *)
