(** Gradients, of which the opacity counts. *)

open Scc_exact

val opacity : Svg_tree.t -> style:(Svg_tree.node -> Svg_style.t) -> Svg_tree.node -> (Rat.t * Rat.t) option
(** [opacity tree ~style gradient] are the least and the greatest opacity of the stops of a gradient, or of the one
    that it refers to; [None] if there are no stops, so that nothing is painted. [style] is the style of an element
    where it stands. Raises {!Svg_number.Bad} and {!Svg_number.Unread}. *)
