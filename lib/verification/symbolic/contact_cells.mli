(** Rule Ftoc where the offset of two solids is not known but for what it depends on: their velocities are, and
    so the time at which they collide is affine, on each of finitely many regions that linear constraints
    describe. *)

open Scc_exact
open Scc_geometry
open Scc_polyhedra

(** A region on which they collide. *)
type hit = {
  region : Polyhedron.t;
  time : Linear.t;  (** when they do; at least 0 *)
  tight : int list;
  (** the facets of the obstacle that hold the offset then, by their indices, increasing: all other facets have it
      strictly inside *)
}

val make :
  Obstacle.t -> offset:Linear.t * Linear.t * Linear.t -> velocity:Vec.t -> limit:Linear.t option -> Polyhedron.t ->
  hit list * Polyhedron.t list
(** [make o ~offset ~velocity ~limit within]: of two solids with the obstacle [o], the offset now (of B from A) and
    the velocity of B less that of A; they interpenetrate now nowhere in [within], over whose variables the
    coordinates of the offset are forms. Where they collide at the limit or before it (at any time, without one),
    and where they do not: disjoint pieces, none empty, that make up [within]. *)
