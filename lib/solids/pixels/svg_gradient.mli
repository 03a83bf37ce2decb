(** Gradients, of which the opacity counts. *)

val opacity :
  Svg_tree.t ->
  style:(Svg_tree.node -> Svg_style.t) ->
  view:Svg_shape.view ->
  box:(unit -> Aspect.box option) ->
  Svg_tree.node ->
  Svg_style.gradient
(** [opacity tree ~style ~view ~box gradient] is how opaque a gradient is, by its stops or those of the gradient
    that it refers to. [style] is the style of an element where it stands, and [box] the box around what is
    painted. Raises {!Svg_number.Bad} and {!Svg_number.Unread}, and {!Svg_tree.Fault} for a fault in a stop. *)
