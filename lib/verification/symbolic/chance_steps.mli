(** What chance decides of the states of a zone (rules Draw and Lot), and the laws of motion on zones (rule
    Steer). *)

open Scc_polyhedra
open Scc_semantics
open Scc_property
open Scc_state_sets

exception Bad of { fault : Transition.fault; at : Scc_exact.Rat.t array }
(** The transitions of some states have no value (rules Steer, Lot): for these values of the parameters. *)

val settled : Instant.context -> Zone.t -> Zone.t list
(** [settled c z] is [z] after what laws of motion do at the end of a transition ({!Steer.settle}): disjoint
    zones over the same variables. *)

(** A transition of the states of a region, and the zones to which it leads. *)
type way = {
  source : Scc_calculus.State.t;  (** one of these states *)
  label : Transition.label;
  targets : Zone.t list;
}

(** What comes next by chance, or while something is left to it. *)
type t =
  | Drawn of way list  (** with the probabilities of the labels, whose sum is 1 *)
  | Chosen of way list  (** freely: the ways to release bonds that lots were drawn for *)
(** Each way leads to disjoint zones over the variables of the zone, whose sets make up the region. *)

val pending : Zone.t -> bool
(** [pending z] is true if a draw or a lot is pending, so that nothing else may happen. *)

val without_old_velocities : Instant.context -> Zone.t -> Zone.t
(** The zone with the velocity 0 for each process whose next velocity is drawn, or to be drawn, and does not
    depend on the present one. No time passes before that, so that only predicates of velocities tell the two
    zones apart. *)

val all : Instant.context -> events:Property.event array -> Zone.t -> (Polyhedron.t * t) list
(** [all c ~events z], for a zone where something is {!pending}: regions that divide it, with what comes next. *)
