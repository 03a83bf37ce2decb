(** What a [switch] draws. *)

val children : Svg_tree.node -> Svg_tree.node list
(** [children node] are the elements in [node] that are drawn. In a [switch] it is the first one that can be drawn
    and whose conditions hold, without the attributes of these conditions. No extension is known, and all features
    of SVG 1.1 hold, as for browsers. Raises {!Svg_number.Unread} for other conditions before the one that is
    chosen: what is drawn depends on the reader. *)
