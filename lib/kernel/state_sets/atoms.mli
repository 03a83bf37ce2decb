(** State predicates on zones: the regions on which they hold. *)

open Scc_polyhedra
open Scc_property

(** The states on which a predicate is evaluated: all states of a zone. *)
type view = {
  zone : Zone.t;
  passing : bool;  (** the zone is a trajectory of what passes by: nothing has just happened *)
  quiescent : Polyhedron.t list;  (** regions of it on which nothing ever happens again *)
}

type context

val context : Zone_parts.context -> events:Property.event array -> context
(** The context for predicates whose events are numbered as in the array. *)

val truth : context -> Property.prop -> view -> (Polyhedron.t * Scc_ctl.Truth.t) list
(** [truth c prop view] are disjoint regions, none empty, whose union is the set of the zone, with the truth of
    the predicate on each. It is undecided, with a reason, where a number is compared that is not affine, or
    undefined. *)

val number : context -> Property.num -> view -> (Polyhedron.t * (Linear.t, string) result) list
(** [number c num view] are such regions with the number on each, as a form over the variables of the zone; or the
    reason why it is not affine there, or undefined. *)

val possible : context -> Property.prop -> view -> Polyhedron.t list
(** [possible c prop v] are regions that contain all states of [v] in which [prop] is not known to be false. *)
