(** Lines of drawings as polygons, in units of 1/1024 of a pixel. Curves become chains of segments within 1/64
    of a pixel of them, with corners rounded to the unit. *)

open Scc_exact

type polygon = (int * int) list

val unit : int
(** The number of units in a pixel: 1024. *)

type pen
(** Draws polygons under a map from the units of the drawing to pixels. *)

val pen : budget:int ref -> Plane_map.t -> pen
(** [pen ~budget m] is a new pen, whose map to pixels is [m]. The budget is the number of corners that all pens
    together may still draw. Drawing raises {!Svg_number.Bad} if there are more, or if a point is farther than
    2{^14} pixels from the picture. *)

val path : pen -> string -> polygon list
(** [path pen data] draws the data of a path, and returns all polygons of the pen so far. *)

val points : pen -> Plane_map.point list -> polygon list
(** [points pen corners] draws a polygon with these corners, and returns all polygons of the pen so far; none
    if there are no corners. *)

val ellipse : pen -> Plane_map.point -> Rat.t -> Rat.t -> polygon list
(** [ellipse pen centre rx ry] draws the ellipse with this centre and these radii, and returns all polygons of
    the pen so far. *)

val rectangle : pen -> Plane_map.point -> Rat.t * Rat.t -> Rat.t * Rat.t -> polygon list
(** [rectangle pen corner (width, height) (rx, ry)] draws the rectangle from its least corner on, with corners
    rounded by these radii. It returns all polygons of the pen so far. *)
