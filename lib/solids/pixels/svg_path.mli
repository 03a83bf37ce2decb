(** The lines of shapes: of path data, and of the basic shapes as paths. Reading raises {!Svg_number.Bad}. *)

open Scc_exact

val path : string -> Svg_segment.outline
(** [path data] is the outline of the data of a path, which are read each time that it is used.
    It is empty for [none]. *)

val points : closed:bool -> Plane_map.point list -> Svg_segment.outline
(** [points ~closed corners] is the line along these corners, and back to the first one if [closed]; nothing if
    there are no corners. *)

val ellipse : Plane_map.point -> Rat.t -> Rat.t -> Svg_segment.outline
(** [ellipse centre rx ry] is the ellipse with this centre and these radii. *)

val rectangle : Plane_map.point -> Rat.t * Rat.t -> Rat.t * Rat.t -> Svg_segment.outline
(** [rectangle corner (width, height) (rx, ry)] is the rectangle from its least corner on, with corners rounded
    by these radii. *)
