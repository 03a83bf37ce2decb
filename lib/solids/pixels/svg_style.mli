(** The style of an element of SVG: its own properties, and those that it inherits. *)

open Scc_exact

type t = {
  fill : Css_colour.paint;
  fill_opacity : Rat.t;
  rule : Fill.rule;
  clip_rule : Fill.rule;
  colour : Css_colour.colour;  (** the property [color] *)
  stroke : Css_colour.paint;
  stroke_opacity : Rat.t;
  width : string;  (** of strokes, a length *)
  cap : Svg_stroke.cap;
  join : [ `Miter | `Round | `Bevel ];
  limit : Rat.t;  (** of miters *)
  dashes : string list;  (** lengths *)
  offset : string;  (** of dashes, a length *)
  stroke_first : bool;  (** strokes are painted before the inside *)
  markers : bool;
  shown : bool;  (** visible *)
  displayed : bool;  (** of elements that are not, nothing inside is either *)
  opacity : Rat.t;  (** of all elements around together *)
  own : own;
}

(** What is not inherited. *)
and own = {
  clip : string option;  (** the id of a clip path *)
  clipped : bool;  (** nothing is drawn beyond a viewport *)
  fixed_width : bool;  (** the width of strokes is not in units of the drawing *)
}

val initial : t
(** The style outside of all elements: a black fill by the rule [Nonzero], visible, opaque, without a
    stroke. *)

val of_properties : t -> (string * string) list -> t
(** [of_properties around properties] is the style of an element with these properties
    ({!Svg_declarations.of_element}) within an element of the style [around]. Raises {!Svg_number.Bad} and
    {!Svg_number.Unread}. *)

val painted : t -> Css_colour.paint -> Rat.t -> has:(string -> bool) -> int option
(** [painted style paint opacity ~has] is the colour, 0xRRGGBB, in which the paint is seen at this opacity: if
    it is at least half opaque together with all around it. [has] is true for ids of gradients, which count as
    opaque and black. Raises {!Svg_number.Bad} for another id without a paint in its place. *)

val stroke : t -> length:(string -> Rat.t) -> Svg_stroke.t option
(** [stroke style ~length] is the pen of the style, if it has a width; [length] reads lengths. Raises
    {!Svg_number.Bad} and {!Svg_number.Unread}. *)
