(** All next steps from a zone. *)

open Scc_polyhedra
open Scc_semantics
open Scc_property
open Scc_state_sets

type step =
  | Happens of Transition.label
  | Passes of Linear.t  (** so much time, until the next event *)
  | Passes_some  (** less than that, or no time: time is halted for a weak split *)

type t = {
  steps : (step * Zone.t) list;
  (** targets are over the variables of the zone, and of a {!Passes_some} over one more, the last one: the time
      that passes; their sets are where the step is taken *)
  postponed : (step * Zone.t) list;
  (** like [steps]; these may as well come after some of the others (rule Order), unless one of those leads to
      a known zone *)
  cells : Passing.due First.cell list;
  (** regions on which time passes undisturbed until the first events, with these events *)
}

val all : ?visible:(int -> bool) -> Instant.context -> events:Property.event array -> Zone.t -> t
(** All next steps from a zone. With [visible], the leaves that are observed, some events at one instant that
    cannot influence each other are {!postponed}. *)
