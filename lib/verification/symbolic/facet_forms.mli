(** Facets of an obstacle, for an offset whose coordinates are forms. *)

open Scc_geometry
open Scc_polyhedra

val room : Linear.t * Linear.t * Linear.t -> Obstacle.facet -> Linear.t
(** [room offset facet] is how far the offset is inside the plane of the facet, in units of its normal:
    positive inside, negative beyond. *)
