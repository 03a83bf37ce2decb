(** Rule Contact for an offset of two solids that is a form over variables. *)

open Scc_geometry
open Scc_polyhedra

type relation =
  | Apart
  | Touching of int list  (** the indices, increasing, of the facets of the obstacle that contain the offset *)
  | Interpenetrating

val make : Obstacle.t -> offset:Linear.t * Linear.t * Linear.t -> Polyhedron.t -> (Polyhedron.t * relation) list
(** [make o ~offset within] are regions, disjoint and not empty, whose union is [within], with the relation of
    the solids on each. Two regions with [Touching] by the same facets may occur only if they are one
    region. *)
