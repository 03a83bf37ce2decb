(** The events that formulas speak of ([event bind(a, p, q)]), told of transitions. *)

open Scc_calculus
open Scc_semantics
open Scc_property

val matches : source:State.t -> Transition.label -> Property.event -> bool
(** Whether a transition from the state is of the event. Leaves are those at the ends of the bond for binds
    and splits, and any leaf of the two processes for bounces. A strong split is an event of each bond that
    it releases; a passing of time is none. *)

val each : Transition.label -> Transition.label list
(** What happens by a transition, one by one (rule Expectation): of a split each bond that it releases, as the split
    of that bond alone; else the transition itself. Nothing happens by a passing of time. *)
