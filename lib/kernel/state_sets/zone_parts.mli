(** The parts of the processes of a zone, where they are: as forms over its variables. *)

open Scc_geometry
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
