(** The parts of the processes of a zone, where they are: as forms over its variables. *)

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

(** A part of a process, where it is in all states of a zone. *)
type part = { process : State.process; leaf : int; index : int; solid : Solid.t; place : Place.t }

val parts : Model.t -> Zone.t -> State.process -> part list
(** The parts of a process, with their places as forms over the variables of the zone. *)

val all : Model.t -> Zone.t -> part list
(** The parts of all processes, in their order. *)

val pairs : Model.t -> Zone.t -> (part * part) list
(** All pairs of parts of different processes. *)

val offset : part -> part -> Place.t
(** [offset a b] is the vector from the reference point of [a] to that of [b]. *)

val relative_velocity : part -> part -> Scc_exact.Vec.t
(** [relative_velocity a b] is the velocity of [b] less that of [a]. *)

val facets : context -> part * part -> Half_space.t list
(** [facets c (a, b)] are the facets of the obstacle of two parts, for the offset and velocity of [b] from [a]. *)

(** {1 Features} *)

val fitting : context -> part * part -> (Behaviour.channel * Behaviour.channel) list
(** [fitting c (a, b)] are all pairs of channels that are open and fit, the first of the leaf of [a] and the second
    of the leaf of [b] ({!Scc_semantics.Collisions.fitting}). *)

val facing : part * part -> Site.t list * Site.t list -> (Feature_offsets.side * Feature_offsets.side) list
(** [facing (a, b) (ones, twos)] are all pairs of a feature in [ones] that is on [a] and one in [twos] that is on
    [b]. *)

val of_end : part list -> State.finish -> part
(** [of_end parts f] is the part, among [parts], that has the feature of [f]. *)

val joint : context -> Zone.t -> part list -> State.finish * State.finish -> Polyhedron.t
(** [joint c z parts (f, g)] are the values of the variables of [z] at which two features touch. Their parts are
    among [parts]. The result may be empty, and need not be in the set of [z]. *)
