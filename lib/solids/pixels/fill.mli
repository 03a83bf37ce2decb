(** Filled polygons as pixels. *)

type rule = Nonzero | Even_odd

val inside : width:int -> height:int -> rule -> Svg_polygon.polygon list -> (int -> unit) -> unit
(** [inside ~width ~height rule polygons f] calls [f] with the index of each pixel whose centre is inside by the
    rule, exactly. A centre on an edge is inside if the inside is to the right of it or below. Time and memory
    are those of the rows and columns that the polygons cross. *)

val cost : width:int -> height:int -> Svg_polygon.polygon list -> int
(** The number of pixels in the rows and columns that the polygons cross. *)
