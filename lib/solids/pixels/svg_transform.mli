(** Transforms of SVG elements, as an attribute and as a property of CSS. *)

open Scc_exact

val of_text : string -> Plane_map.t
(** [of_text text] is the map of an attribute such as [gradientTransform]. Raises {!Svg_number.Bad}. *)

val is_valid : string -> string -> bool
(** [is_valid property value] is false for a value of [transform], [transform-origin] or [transform-box] in a style
    that CSS ignores for sure. *)

val of_properties : size:Rat.t * Rat.t -> (string * string) list -> Plane_map.t
(** [of_properties ~size properties] is the map of an element with these properties
    ({!Svg_declarations.of_element}), its origin ([transform-origin]) included. [size] is that of the view box, to
    which shares and words of the origin refer. Raises {!Svg_number.Bad} for a transform that is none, such as a
    length without a unit in CSS, which browsers ignore. Raises {!Svg_number.Unread} for shares and for transforms
    in space. *)
