(** The events of formulas, such as [event bind(a, p, q)], as predicates of transitions (rule Event). *)

open Scc_calculus
open Scc_semantics
open Scc_property

val matches : source:State.t -> Transition.label -> Property.event -> bool
(** [matches ~source label event] is true if a transition with this label from the state [source] is of the
    event. For bindings, closings and splits, the leaves of the event are the ends of the bond; a split matches
    by any bond that it releases. For bounces they are any leaves of the processes that bounce, two leaves in two
    processes. For hits they are the leaves or parts that touch. For absorptions they are the absorber or any
    leaf of the absorbed process. No other label matches: passing of time, draws and lots. *)

val each : Transition.label -> Transition.label list
(** [each label] has what happens by a transition, one by one (rule Expectation): for a split each bond that it
    releases, as the split of that bond alone; otherwise the label itself. The passing of time has none. *)
