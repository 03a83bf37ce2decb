(** What may happen at one instant to the states of a region of {!Instant.cells}: the rules are asked of one of its
    states, and what they make of it they make of all. *)

open Scc_polyhedra
open Scc_semantics
open Scc_property

type t = { label : Transition.label; target : Zone.t  (** over the same variables; not canonical *) }

type all = {
  urgent : t list;  (** strong splits, closings and collisions: time does not pass before one of them *)
  weak : t list;  (** weak splits *)
}

val all : Instant.context -> events:Property.event array -> Zone.t -> Polyhedron.t -> all
(** Of a zone that is not {!Zone.t.halted} all, in the order of {!Network.successors}; else weak splits alone.
    Targets know which of the events they have been reached by. *)
