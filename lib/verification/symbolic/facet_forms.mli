(** Facets of an obstacle, as an offset that depends on what is not known sees them. *)

open Scc_geometry
open Scc_polyhedra

val room : Linear.t * Linear.t * Linear.t -> Obstacle.facet -> Linear.t
(** How far the offset is inside the plane of the facet, in units of its normal: positive inside, negative
    beyond. *)
