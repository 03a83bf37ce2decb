(** The lines of a drawing as chains of chords, for strokes and for bounds. *)

open Scc_exact

(** A segment between two corners of a line: a straight one, or a curve as a chain of chords. *)
type strand = {
  places : Plane_map.point list;  (** at least two; neighbours differ *)
  leaves : Plane_map.point;  (** the direction in which the strand leaves its first place, not 0 *)
  arrives : Plane_map.point;  (** the direction in which it arrives at its last place, not 0 *)
}

type line = {
  strands : strand list;  (** each begins where the one before ends; none for a line that is a point *)
  start : Plane_map.point;
  closed : bool;
}

val lines :
  budget:Svg_polygon.budget ->
  check:(Plane_map.point -> unit) ->
  share:int ->
  half:Rat.t ->
  Plane_map.t ->
  Svg_segment.outline ->
  line list
(** [lines ~budget ~check ~share ~half m outline] are the images under [m] of the lines of an outline that have a
    segment, if only one of length 0. Chords are within [1/share] of their curves. At both ends of a curve,
    chord and curve differ in direction so little that normals of the length [half] differ by at most [1/share]
    (or by what thirty halvings leave). [check] is called with some places of each curve. Raises
    {!Svg_number.Bad} if there are more places than the budget has. *)
