(** Parts cut further, until each of their features shows one thing of the drawn solid at most. *)

open Scc_exact
open Scc_geometry

val solid : Vec.t list -> Polyhedron.t
(** The convex hull of points that are not in one plane (a bug otherwise); names are of no meaning. *)

val halves : Drawn.region -> Polyhedron.t -> Polyhedron.t * Polyhedron.t
(** What is behind the plane of the region, and what is before it; the plane divides the part. *)

val parts :
  tick:(left:int -> unit) -> Shown.t -> Drawn.t -> limit:int -> Polyhedron.t list ->
  (Polyhedron.t * (Feature.t * Drawn.feature list) list) list option
(** Convex parts of the solid, each with what its features show: where a face shows pieces of two regions, or an
    edge goes on from a border into a region, the plane of a face of the solid that divides it cuts its part in
    two. [None] if there would be more parts than the limit. [tick] is called for each, with how many are left. *)
