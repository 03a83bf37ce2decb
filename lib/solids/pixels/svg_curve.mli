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

val check_places : check:(Plane_map.point -> unit) -> Plane_map.point list -> unit
(** [check_places ~check controls] calls [check] with five points of the Bezier curve. If all of them are within a
    distance, then {!pieces} is small for it. *)

(** An arc of the unit circle, and the map that takes it to its ellipse. *)
type circular = {
  map : Plane_map.t;
  start : Plane_map.point;
  middle : Plane_map.point;
  stop : Plane_map.point;
  forward : bool;  (** towards growing angles *)
  wide : bool;  (** more than half of the circle *)
  bits : int;  (** points of the circle are within 2{^-bits} of it *)
}

val circular : stretch:Rat.t -> extra:int -> Plane_map.point -> Svg_segment.arc -> circular option
(** [circular ~stretch ~extra here arc] is the arc of an ellipse that begins at [here], as SVG's notes on
    implementation have it: radii that are too small grow. It is not the whole ellipse. The images of both ends
    are exact. Those of all other points are within 2{^-14} pixels of the exact arc, if a length grows to [stretch]
    pixels at most. [bits] has [extra] more than this needs. [None] if [arc] is the segment from [here] to its end:
    an end there, or a radius 0. Raises {!Svg_number.Bad} if that takes numbers of more than two thousand bits. *)

val middle : circular -> Plane_map.point -> Plane_map.point -> Plane_map.point
(** [middle arc u v] is the middle of a part from [u] to [v], at most half of the unit circle, of an arc. *)

val arc_points :
  share:int -> check:(Plane_map.point -> unit) -> Plane_map.t -> circular -> Plane_map.point list
(** [arc_points ~share ~check map arc] are points of the arc of the unit circle in their order, with both ends. The
    images of the chords between them by [map] are within [1/share] of the image of the arc, or as near as
    seventeen halvings take them. [check] is called with images of points of the arc. *)
