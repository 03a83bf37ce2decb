(** The states of a zone at one instant, divided by the events that happen to them. On each region all inputs
    of the discrete rules are the same. So the result of the rules for one state is valid for the whole
    region. *)

open Scc_geometry
open Scc_polyhedra
open Scc_offsets
open Scc_calculus
open Scc_semantics

type context = {
  semantics : Semantics.t;
  obstacle : Solid.t -> Solid.t -> Obstacle.t;
  features : Feature_offsets.memory;
}

val context : Semantics.t -> context
(** A context with new caches. *)

val semantics_at : context -> Zone.t -> Scc_exact.Rat.t array -> Semantics.t
(** [semantics_at c z point] are the rules for the state of [z] at these values of its variables. The places of
    parts in their leaves are those of that state. *)

exception Not_affine of string
(** The reason, for readers, why the numbers of successors of a zone are not affine, or not known. *)

(** A part of a process, where it is in all states of a zone. *)
type part = { process : State.process; leaf : int; index : int; solid : Solid.t; place : Place.t }

val parts : Model.t -> Zone.t -> State.process -> part list
(** The parts of a process, with their places as forms over the variables of the zone. *)

val pairs : Model.t -> Zone.t -> (part * part) list
(** All pairs of parts of different processes. *)

val offset : part -> part -> Place.t
(** [offset a b] is the vector from the reference point of [a] to that of [b]. *)

val relative_velocity : part -> part -> Scc_exact.Vec.t
(** [relative_velocity a b] is the velocity of [b] less that of [a]. *)

val meeting_offsets : context -> part * part -> Polyhedron.t list
(** Sets of offsets at which features have a common point (reading I-33). There is one for each two features,
    which are closed, that two parts list for channels that are open now and fit. *)

val cells : context -> Zone.t -> Polyhedron.t list
(** Regions of the zone that are disjoint, not empty, and whose union is the zone. Throughout each of them, the
    same parts collide, and all contacts between the processes that collide are the same. The same features of
    open channels touch, and closings and pushes have the same results. With [binding contact], all contacts
    between parts with open channels that fit are the same, too. Collisions are not considered in
    {!Zone.t.halted} zones. Raises {!Not_affine} for a push along an unknown line. *)
