(** Points of curves, exactly or nearly. *)

open Scc_exact

val ( +: ) : Plane_map.point -> Plane_map.point -> Plane_map.point
(** The sum of two vectors. *)

val ( -: ) : Plane_map.point -> Plane_map.point -> Plane_map.point
(** The difference of two vectors. *)

val ( *: ) : Rat.t -> Plane_map.point -> Plane_map.point
(** The multiple of a vector. *)

val cross : Plane_map.point -> Plane_map.point -> Rat.t
(** [cross u v] is greater than 0 if [v] is turned from [u] as y is from x, by less than half a turn. *)

val dot : Plane_map.point -> Plane_map.point -> Rat.t
(** The scalar product. *)

val same : Plane_map.point -> Plane_map.point -> bool
(** [same p q] is true for equal points. *)

val bezier : Rat.t -> Plane_map.point list -> Plane_map.point
(** [bezier t controls] is the point of the parameter [t], exactly, after de Casteljau. *)

val pieces : share:int -> Plane_map.point list -> int
(** [pieces ~share controls] is the number of pieces of equal parameter ranges, at most 10{^6}, whose chords are
    within [1/share] of the Bezier curve with these control points, all of them. *)

(** An arc of the unit circle, from [start] to [stop], and the map that takes it to its ellipse. *)
type circular = { map : Plane_map.t; start : Plane_map.point; stop : Plane_map.point; forward : bool }

val circular : Plane_map.point -> Svg_segment.arc -> circular option
(** [circular here arc] is the arc of an ellipse that begins at [here], as SVG's notes on implementation have
    it: radii that are too small grow. It is not the whole ellipse. [None] if [arc] is the segment from [here] to
    its end: an end there, or a radius 0. *)

val middle : forward:bool -> Plane_map.point -> Plane_map.point -> Plane_map.point
(** [middle ~forward u v] is the middle of the arc of the unit circle from [u] to [v], towards growing angles if
    [forward]. Its coordinates are multiples of 2{^-36}. *)

val halvings : share:int -> Plane_map.t -> int
(** [halvings ~share map] is how many times arcs of the unit circle are halved, at most 14, until the images of
    their chords are within [1/share] of the images of the arcs. *)
