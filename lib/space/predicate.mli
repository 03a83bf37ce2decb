(** State predicates over the tuples of {!System}. *)

open Scc_ctl
open Scc_property

val make : System.context -> Property.prop -> Engine.predicate
(** Predicates that do not change while time passes undisturbed are judged by the components of a state, each of
    which is looked at once; the others along the trajectory (see {!Trajectory}). *)
