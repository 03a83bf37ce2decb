(** Rule Contact where the offset of two solids is not known but for what it depends on. *)

open Scc_geometry
open Scc_polyhedra

type relation =
  | Apart
  | Touching of int list  (** the facets of the obstacle that hold the offset, by their indices, increasing *)
  | Interpenetrating

val make : Obstacle.t -> offset:Linear.t * Linear.t * Linear.t -> Polyhedron.t -> (Polyhedron.t * relation) list
(** [make o ~offset within]: regions, none empty, that are disjoint and make up [within], with how the solids
    stand to each other there. Touching on two regions may be by the same facets only if it is one region. *)
