(** The states of a zone at one instant, apart by what happens to them: regions on each of which everything that
    the discrete rules look at is the same, so that what they make of one state there they make of all. *)

open Scc_geometry
open Scc_polyhedra
open Scc_calculus
open Scc_semantics

type context = {
  semantics : Semantics.t;
  obstacle : Solid.t -> Solid.t -> Obstacle.t;
  features : Feature_cells.memory;
}

val context : Semantics.t -> context
(** With new memories. *)

val semantics_at : context -> Zone.t -> Scc_exact.Rat.t array -> Semantics.t
(** For the state that the variables of the zone have these values in: with the places of parts in their leaves
    that belong to it. *)

exception Not_affine of string
(** Why the numbers of what comes of a zone are not affine, or why it is not known, for a person. *)

(** A part of a process, where it is in all states of a zone. *)
type part = { process : State.process; leaf : int; index : int; solid : Solid.t; place : Place.t }

val parts : Model.t -> Zone.t -> State.process -> part list

val pairs : Model.t -> Zone.t -> (part * part) list
(** All two of different processes. *)

val offset : part -> part -> Place.t
(** Of the second from the first. *)

val relative_velocity : part -> part -> Scc_exact.Vec.t

val meeting_offsets : context -> part * part -> Polyhedron.t list
(** For each two features that two parts list for channels that are open now and fit: the offsets at which the
    features, which are closed, have a point in common (reading I-33). *)

val cells : context -> Zone.t -> Polyhedron.t list
(** Regions of the zone, none empty, that are disjoint and make it up. On each, the same parts collide, all that
    the processes that collide touch each other with is the same, the same features of open channels touch, and so
    do closings and pushes find the same; with [binding contact] all that parts touch each other with that have
    open channels which fit. Of {!Zone.t.halted} zones what collides is not looked at. *)
