(** The basic shapes and paths of SVG. *)

open Scc_exact

(** The sides of the viewport, of which percentages are taken. *)
type view = { width : Rat.t; height : Rat.t }

val across : view -> string -> Rat.t
(** The length of a text, where percentages are of the width of the viewport. Raises {!Svg_number.Bad} and
    {!Svg_number.Unread}, as the others do. *)

val down : view -> string -> Rat.t
(** The length of a text, where percentages are of the height of the viewport. *)

val along : view -> string -> Rat.t
(** The length of a text, where percentages are of the root of the mean of the squares of both sides. *)

val outline : view -> Svg_tree.node -> Svg_segment.outline
(** The outline of an element that is a shape; nothing if a size is 0. It, or its use, raises {!Svg_number.Bad}
    and {!Svg_number.Unread}. *)
