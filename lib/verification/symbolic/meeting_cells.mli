(** When two solids, or two of their features, first meet, for an offset whose coordinates are forms over
    variables. Velocities are constants. So the time is affine on each of finitely many regions that linear
    constraints describe. *)

open Scc_exact
open Scc_geometry
open Scc_polyhedra

val of_solids :
  Obstacle.t -> offset:Linear.t * Linear.t * Linear.t -> velocity:Vec.t -> limit:Linear.t option -> Polyhedron.t ->
  (Polyhedron.t * Linear.t) list * Polyhedron.t list
(** [of_solids o ~offset ~velocity ~limit within] is rule Ftoc for two solids A and B with the obstacle [o]. The
    offset now, of B from A, has forms over the variables of [within] as coordinates. The velocity is that of B
    less that of A. Nowhere in [within] do they interpenetrate now. The first list has the regions where they
    collide at the limit or before it, or at any time without a limit, each with the time, which is at least 0.
    The second list has the regions where they do not. All pieces are disjoint, none is empty, and their union is
    [within]. *)

val of_features :
  Polyhedron.t -> offset:Linear.t * Linear.t * Linear.t -> velocity:Vec.t -> limit:Linear.t option ->
  Polyhedron.t ->
  (Polyhedron.t * Linear.t) list * Polyhedron.t list
(** [of_features offsets ~offset ~velocity ~limit within] is reading I-33, where [offsets] is the closed polyhedron
    of offsets at which two features, which are closed, have a common point. The other arguments and the result are
    as in {!of_solids}: where the features first meet, now or later and not after the limit, and where not. *)
