(** Which of a drawn solid's faces, edges and corners the features of its convex parts show. *)

open Scc_exact
open Scc_geometry

type t

val make : Drawn.t -> t

val features : t -> Polyhedron.t -> (Feature.t * Drawn.feature list) list
(** Of a part of the solid: each feature that is seen from outside, with what it shows. That is more than one where
    a face shows pieces of several regions, or an edge comes out of a border into a region; an edge or a corner
    inside a region shows that region. What is glued to other parts and seen nowhere is not listed. *)

val share : Vec.t -> Vec.t array -> Vec.t array -> bool
(** Two convex polygons of a plane with this normal, the first counter-clockwise about it, the other one
    clockwise, have an area in common. *)

val overlap : Drawn.region -> Vec.t array -> bool
(** A convex polygon in the plane of the region, counter-clockwise as seen from outside, has an area in common
    with it. *)
