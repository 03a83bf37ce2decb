(** Bounding boxes of elements (SVG 2, 8.10), in their own coordinates. *)

val user_space :
  Svg_scene.scene -> Svg_scene.around -> Svg_tree.node -> size:Svg_tree.node -> Aspect.box option
(** [user_space scene here node ~size] is the least box around what [node] draws, in the coordinates in which it
    draws, transformed by its own transform; [None] if it draws nothing, or is scaled to nothing. [here] is
    around what it holds. Strokes, clips and visibility do not count, elements that are not displayed are left
    out, and curves are as exact as {!Svg_polygon.filled}. [size] is the element that gives the width and height
    of a viewport: [node], or the [use] that refers to it. Raises {!Svg_number.Bad} and {!Svg_number.Unread}. *)
