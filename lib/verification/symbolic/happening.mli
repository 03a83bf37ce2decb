(** The events that may happen at one instant to the states of a region of {!Instant.cells}. The rules are
    applied to one state of the region; the result is the same for all of its states. *)

open Scc_polyhedra
open Scc_semantics
open Scc_property
open Scc_state_sets

type t = {
  source : Scc_calculus.State.t;  (** the state to which the rules were applied *)
  label : Transition.label;
  target : Zone.t;  (** over the same variables; not canonical *)
}

val of_outcome :
  Instant.context -> events:Property.event array -> Zone.t -> Polyhedron.t -> Scc_calculus.State.t ->
  step:Scc_calculus.State.step option -> Transition.outcome -> t list
(** [of_outcome c ~events z region state ~step o] is an outcome at one state of a region, for the whole region.
    [step] is the movement step after it. There are several if delays that begin may have the length 0. *)

val all : Instant.context -> events:Property.event array -> Zone.t -> Polyhedron.t -> t Network.discrete
(** [all c ~events z region] are the events on the region, each kind in the order of [Network.successors]. For a
    [Zone.t.halted] zone they are only weak splits. Each target contains the numbers of those of [events] by
    which it was reached. *)
