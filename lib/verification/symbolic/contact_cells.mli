(** Rule Ftoc for an offset of two solids that is a form over variables. Velocities are constants. So the time
    of collision is affine on each of finitely many regions that linear constraints describe. *)

open Scc_exact
open Scc_geometry
open Scc_polyhedra

(** A region on which they collide. *)
type hit = {
  region : Polyhedron.t;
  time : Linear.t;  (** the time of the collision; at least 0 *)
  tight : int list;
  (** the indices, increasing, of the facets of the obstacle that contain the offset then; it is strictly
      inside all others *)
}

val make :
  Obstacle.t -> offset:Linear.t * Linear.t * Linear.t -> velocity:Vec.t -> limit:Linear.t option -> Polyhedron.t ->
  hit list * Polyhedron.t list
(** [make o ~offset ~velocity ~limit within] is for two solids A and B with the obstacle [o]. The offset now,
    of B from A, has forms over the variables of [within] as coordinates. The velocity is that of B less that
    of A. Nowhere in [within] do they interpenetrate now. The hits are the regions where they collide at the
    limit or before it, or at any time without a limit. The other regions are those where they do not. All
    pieces are disjoint, none is empty, and their union is [within]. *)
