(** Cuts a set of states until all that the discrete rules look at is the same in each piece: by brute force,
    along every plane that could matter. *)

open Scc_polyhedra
open Scc_semantics
open Scc_symbolic

type context = {
  semantics : Semantics.t;
  obstacle : Scc_geometry.Solid.t -> Scc_geometry.Solid.t -> Scc_geometry.Obstacle.t;
}

val context : Semantics.t -> context

val by_signs : Linear.t list -> Polyhedron.t list -> Polyhedron.t list
(** Cut by where each form is 0, positive and negative. *)

type part = {
  leaf : int;
  index : int;  (** in the leaf *)
  process : int;  (** the first leaf of its process *)
  solid : Scc_geometry.Solid.t;
  place : Place.t;
  velocity : Scc_exact.Vec.t;
}

val parts : context -> Zone.t -> part list

val rooms : context -> part * part -> (Linear.t * Scc_exact.Rat.t) list
(** For each plane of the obstacle of two parts: how far inside of it the second one is, and how fast that falls:
    negative where it enters. *)

val well_formed : context -> Zone.t -> Polyhedron.t list
(** Regions that have all states in which no two bodies interpenetrate. *)

val bonds_touch : context -> Zone.t -> Constraint.t list
(** That the features that a bond joins touch. *)

val cells : context -> Zone.t -> Polyhedron.t list
(** Regions that make up the zone. On each the same parts touch by the same planes, and of those that touch the
    same features do. *)
