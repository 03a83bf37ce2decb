(** How often what is counted happens by one transition (rule Expectation). *)

open Scc_calculus
open Scc_semantics
open Scc_property

(** A number of things that happen, enclosed. The bounds differ if a predicate is undecided for some of them. *)
type t = { least : int; most : int }

val by : Semantics.t -> source:State.t -> Transition.label -> Property.prop -> t
(** [by semantics ~source label p] is the number of things for which [p] holds, among those that happen by a
    transition with this label from the state [source] ({!Event.each}). [p] is made of events alone. *)
