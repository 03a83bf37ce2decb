(** The style of an element of SVG: its own properties, and those that it inherits. *)

open Scc_exact

(** A colour, or that of the property [color]. *)
type paint = Nothing | Colour of int | Current

type t = {
  fill : paint;
  color : int option;
  rule : Fill.rule;
  shown : bool;  (** visible *)
  displayed : bool;  (** of elements that are not, nothing inside is either *)
  opacity : Rat.t;  (** of all elements around together *)
  fill_opacity : Rat.t;
  stroke : paint;
  stroke_width : Rat.t;
  stroke_opacity : Rat.t;
}

val initial : t
(** The style outside of all elements: a black fill by the rule [Nonzero], visible, opaque, without a
    stroke. *)

val of_properties : t -> (string * string) list -> t
(** [of_properties around properties] is the style of an element with these properties
    ({!Svg_declarations.of_element}) within an element of the style [around]. Raises {!Svg_number.Bad} and
    {!Svg_number.Unread}. *)

val fill : t -> int option
(** The colour with which the area is filled: [None] if there is none, or if it is less than half opaque. *)

val stroked : t -> bool
(** [stroked s] is true if a stroke of some width is painted. *)
