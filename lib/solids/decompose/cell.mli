(** Bounded convex cells of space, by their facets. *)

open Scc_exact

type facet = { plane : Plane.t; corners : Homogeneous.t array }
(** The cell is behind the plane; the corners run counter-clockwise as seen from in front. *)

type t = facet list

val box : Vec.t -> Vec.t -> t
(** [box low high] is the box with these least and greatest corners, which differ in all coordinates. *)

val clip : t -> Plane.t -> t option
(** The part of the cell behind the plane; [None] if that is at most a piece of the cell's boundary. *)

val corners : t -> Homogeneous.t list
(** The corners of all facets, sorted by {!Homogeneous.compare}, each once. *)

type position = Behind | In_front | On | Across

val position : Plane.t -> Homogeneous.t array -> position
(** The position of the convex hull of points relative to a plane. *)

val behind : Plane.t -> Homogeneous.t array -> Homogeneous.t array
(** The part behind the plane of a convex polygon that is {!Across} it. *)
