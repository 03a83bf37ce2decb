(** State predicates on zones: where they hold. *)

open Scc_polyhedra
open Scc_property

(** Where one looks: at all states of a zone. *)
type view = {
  zone : Zone.t;
  passing : bool;  (** the zone is a trajectory ({!Passing.trajectory}): nothing has just happened *)
  quiescent : Polyhedron.t list;  (** regions of it on which nothing ever happens again *)
}

type context

val context : Instant.context -> events:Property.event array -> context

val truth : context -> Property.prop -> view -> (Polyhedron.t * Scc_ctl.Truth.t) list
(** Disjoint regions, none empty, that make up the set of the zone. Undecided, with the reason, where a number is
    compared that is not affine, or undefined. *)
