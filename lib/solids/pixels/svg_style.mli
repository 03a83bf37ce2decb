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
  markers : bool * bool * bool;  (** at the start, in the middle and at the end of lines *)
  shown : bool;  (** visible *)
  displayed : bool;  (** of elements that are not, nothing inside is either *)
  own : own;
}

(** What is not inherited. *)
and own = {
  clip : string option;  (** the id of a clip path *)
  clipped : bool;  (** nothing is drawn beyond a viewport *)
  fixed_width : bool;  (** the width of strokes is not in units of the drawing *)
  opacity : Rat.t;  (** of the element as a group *)
  blended : bool;  (** its colours are mixed with those below it, which changes no opacity *)
}

val initial : t
(** The style outside of all elements: a black fill by the rule [Nonzero], visible, opaque, without a
    stroke. *)

val of_properties : t -> (string * string) list -> t
(** [of_properties around properties] is the style of an element with these properties
    ({!Svg_declarations.of_element}) within an element of the style [around]. Raises {!Svg_number.Bad} and
    {!Svg_number.Unread}. *)

val is_valid : string -> string -> bool
(** [is_valid property value] is false for a value that CSS ignores for sure: one that is none of the property's.
    It is true for what is not read, but has or may have a meaning. *)

(** How opaque a gradient is: between two numbers, not at all, or as if it were not there. *)
type gradient = Between of Rat.t * Rat.t | Unseen | Ignored

val painted :
  t -> Css_colour.paint -> Rat.t -> gradient:(string -> gradient option) -> Svg_layer.source option
(** [painted style paint opacity ~gradient] is the paint at this opacity, if anything is seen of it. [gradient]
    is [None] for an id of no gradient. Gradients count as black. Where a gradient is ignored or is none, the
    paint in its place counts, and otherwise nothing. Raises {!Svg_number.Bad} for an id of no gradient without a
    paint in its place. *)

val stroke : t -> length:(string -> Rat.t) -> Svg_stroke.t option
(** [stroke style ~length] is the pen of the style, if it has a width; [length] reads lengths. Raises
    {!Svg_number.Bad} and {!Svg_number.Unread}. *)
