(** Lines of drawings as polygons, in units of 1/1024 of a pixel. Curves become chains of segments within 1/64
    of a pixel of them, with corners rounded to the unit. *)

type polygon = (int * int) list

val unit : int
(** The number of units in a pixel: 1024. *)

type budget = int ref
(** The number of corners that may still be drawn. Drawing raises {!Svg_number.Beyond} if there are more. *)

val max_corners : int
(** The corners of one drawing: a million. *)

val spend : budget -> int -> unit
(** [spend budget n] takes [n] corners from the budget. *)

val corner : Plane_map.point -> int * int
(** The corner at a place in pixels. Raises {!Svg_number.Bad} if the place is farther than 2{^14} pixels from the
    picture. *)

val check : Plane_map.point -> unit
(** [check place] raises as {!corner} does. *)

val filled : budget:budget -> Plane_map.t -> Svg_segment.outline -> polygon list
(** [filled ~budget m outline] are the polygons inside the lines of an outline, each line closed. [m] is the map
    from the units of the drawing to pixels. *)

val lines : budget:budget -> Plane_map.t -> Svg_segment.outline -> Plane_map.point list list
(** [lines ~budget m outline] are the corners of {!filled} in pixels, not rounded. *)
