(** Bounded convex cells of space, by their facets. *)

open Scc_exact

type facet = { plane : Plane.t; corners : Place.t array }
(** The cell is behind the plane; the corners run counter-clockwise as seen from in front. *)

type t = facet list

val box : Vec.t -> Vec.t -> t
(** From the least and the greatest corner, which differ in all coordinates. *)

val clip : t -> Plane.t -> t option
(** What is behind the plane, [None] if there is nothing but a piece of the boundary. *)

val corners : t -> Place.t list

type position = Behind | In_front | On | Across

val position : Plane.t -> Place.t array -> position
(** Of the convex hull of points. *)

val behind : Plane.t -> Place.t array -> Place.t array
(** Of a convex polygon that is {!Across} the plane, what is behind it. *)
