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

(** Regions, none empty. They are disjoint, and make up the polyhedron that was asked about. *)
type t = {
  hits : hit list;
  misses : Polyhedron.t list;  (** where they never collide, as they graze at most *)
  inside : Polyhedron.t list;  (** where they interpenetrate now *)
}

val make : Obstacle.t -> offset:Linear.t * Linear.t * Linear.t -> velocity:Vec.t -> Polyhedron.t -> t
(** [make o ~offset ~velocity within]: of two solids with the obstacle [o], the offset now (of B from A) and the
    velocity of B less that of A. The coordinates of the offset are forms over the variables of [within]. *)
