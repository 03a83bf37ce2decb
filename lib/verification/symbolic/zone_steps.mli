(** All that may come of a zone next. *)

open Scc_polyhedra
open Scc_semantics
open Scc_property

type step =
  | Happens of Transition.label
  | Passes of Linear.t  (** so much time, until what comes next *)
  | Passes_some  (** less than that, or no time: time is halted for a weak split *)

type t = {
  steps : (step * Zone.t) list;
  (** targets are over the variables of the zone, and of a {!Passes_some} over one more, the last one: the time
      that passes; their sets are where the step is taken *)
  postponed : (step * Zone.t) list;
  (** likewise; what may as well come after some of the others (rule Order), unless one of these leads to what is
      known *)
  cells : Passing.due First.cell list;
  (** regions on which time passes, with what comes first: until then it does so undisturbed *)
}

val all : ?visible:(int -> bool) -> Instant.context -> events:Property.event array -> Zone.t -> t
(** With [visible], the leaves that somebody looks at, of events at one instant that cannot influence each other
    some are {!postponed}. *)
