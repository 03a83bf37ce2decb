(** Lines of drawings as polygons, in units of 1/1024 of a pixel. Curves become chains of segments that are nowhere
    farther than 1/64 of a pixel from them, with corners rounded to the unit. *)

open Scc_exact

type polygon = (int * int) list

val unit : int
(** 1024. *)

type pen
(** Draws polygons under a map from the units of the drawing to pixels. *)

val pen : budget:int ref -> Plane_map.t -> pen
(** [budget] is how many corners there may be in all, over all pens. {!Svg_number.Bad} when there are more, or when
    something is farther than 2{^14} pixels from the picture. *)

val path : pen -> string -> polygon list
(** Of the data of a path. *)

val points : pen -> Plane_map.point list -> polygon list
(** Of a polygon. *)

val ellipse : pen -> Plane_map.point -> Rat.t -> Rat.t -> polygon list
(** Of centre and radii. *)

val rectangle : pen -> Plane_map.point -> Rat.t * Rat.t -> Rat.t * Rat.t -> polygon list
(** Of its corner, width and height, and the radii of its corners. *)
