(** Strokes of lines as areas: the region that a pen of a width paints along them, as SVG 2 defines it (section 13,
    "Painting"), with caps, joins and dashes. *)

open Scc_exact

type cap = Butt | Round_cap | Square
type join = Miter of Rat.t  (** with its limit, at least 1 *) | Round | Bevel

type t = {
  half : Rat.t;  (** half of the width, more than 0, in units of the drawing *)
  cap : cap;
  join : join;
  dashes : Rat.t list;  (** lengths of dashes and gaps, an even number, none negative, not all 0; [[]] for none *)
  offset : Rat.t;  (** where in the dashes a line begins *)
}

val triangles :
  budget:Svg_polygon.budget -> Plane_map.t -> t -> Svg_segment.outline -> Svg_polygon.polygon list
(** [triangles ~budget m stroke outline] are triangles whose union is the stroke of the lines. All of them run
    the same way round, so that {!Fill.inside} by the rule [Nonzero] gives the union. [m] is the map from the
    units of the drawing to pixels, after the stroke. Boundaries are within 1/64 of a pixel of the exact ones.
    Straight lines have the exact stroke, but for square roots (of forty bits) and corners rounded to 1/1024 of
    a pixel; lengths of dashes on curves are those of chords. With dashes, a line without a length has no
    stroke. Raises {!Svg_number.Bad} as {!Svg_polygon} does. *)
