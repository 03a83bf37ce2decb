(** How often what is counted happens by one transition (rule Expectation). *)

open Scc_calculus
open Scc_semantics
open Scc_property

(** Where it is undecided of some of what happens, the least number and the greatest differ. *)
type t = { least : int; most : int }

val by : Semantics.t -> source:State.t -> Transition.label -> Property.prop -> t
(** Of what happens by a transition from the state ({!Event.each}), how much is so. The predicate is made of events
    alone. *)
