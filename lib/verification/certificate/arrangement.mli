(** Cuts of a set of states into pieces, by brute force, along every plane that could matter. All inputs of the
    discrete rules are the same throughout a piece. *)

open Scc_polyhedra
open Scc_offsets
open Scc_semantics
open Scc_state_sets

type context = {
  semantics : Semantics.t;
  obstacle : Scc_geometry.Solid.t -> Scc_geometry.Solid.t -> Scc_geometry.Obstacle.t;
}

val context : Semantics.t -> context
(** A context for the rules of a model, with a new cache of obstacles. *)

val by_signs : Linear.t list -> Polyhedron.t list -> Polyhedron.t list
(** [by_signs forms regions] cuts the regions by the signs of all forms: where each is 0, positive or negative.
    No piece is empty. *)

type part = {
  leaf : int;
  index : int;  (** in the leaf *)
  process : int;  (** the first leaf of its process *)
  solid : Scc_geometry.Solid.t;
  place : Place.t;
  velocity : Scc_exact.Vec.t;
}

val parts : context -> Zone.t -> part list
(** All parts of all processes, with their places as forms over the variables of the zone. *)

val facets : context -> part * part -> Half_space.t list
(** [facets c (a, b)] are the facets of the obstacle of two parts, for the offset and velocity of [b] from [a]. *)

val well_formed : context -> Zone.t -> Polyhedron.t list
(** Regions that contain all states of the zone in which no two bodies interpenetrate. *)

val bonds_touch : context -> Zone.t -> Constraint.t list
(** Constraints which say that the features touch that bonds join. *)

val cells : context -> Zone.t -> Polyhedron.t list
(** Regions whose union is the zone. Throughout each of them the same parts touch, by the same planes, and the
    same features of them touch. *)
