(** Clip paths of SVG. *)

open Svg_scene

val within : Bytes.t option -> int -> bool
(** [within clip k] is true if the pixel of the index [k] is painted at all. *)

val mask : scene -> Bytes.t
(** A clip in which nothing is painted. *)

val add : scene -> Bytes.t -> Bytes.t option -> Fill.rule -> Svg_polygon.polygon list -> unit
(** [add scene found clip rule polygons] adds to the clip [found] what is inside of polygons and within [clip]. *)

val style_at : scene -> Svg_tree.node -> Svg_style.t
(** [style_at scene node] is the style of an element where it stands in the document. *)

val clipped : ?size:Svg_tree.node -> scene -> around -> Svg_tree.node -> around
(** [clipped scene here node] is [here], around what [node] holds, within the clip path of [node]. [size] is as for
    {!Svg_box.user_space}, [node] by default. Raises {!Svg_number.Bad} and {!Svg_number.Unread}. *)
