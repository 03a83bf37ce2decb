(** A drawing of SVG while it is painted: its layer, its limits, and what is around an element. *)

type scene = {
  tree : Svg_tree.t;
  raster : Raster.t;
  corners : Svg_polygon.budget;
  mutable layer : Svg_layer.t;  (** what is painted on *)
  mutable fading : ((int * int) * string) option;  (** a gradient whose opacity is not the same everywhere *)
  mutable blended : (int * int) option;  (** the first element whose colours are mixed *)
  mutable drawn : int;  (** how many elements *)
  mutable area : int;  (** how many pixels were looked at *)
  mutable at : int * int;  (** the place of the element that is being drawn *)
}
(** The functions below raise {!Svg_number.Bad} where the drawing exceeds a limit. *)

type around = {
  style : Svg_style.t;
  map : Plane_map.t;  (** to pixels *)
  clip : Bytes.t option;  (** where is painted at all: pixels that are not 0 *)
  view : Svg_shape.view;
  depth : int;
  used : Svg_tree.node list;  (** what is being used here *)
}
(** What is around an element. *)

val look : scene -> int -> unit
(** [look scene n] counts [n] pixels that are looked at. *)

val inside : scene -> Fill.rule -> Svg_polygon.polygon list -> (int -> unit) -> unit
(** [inside scene rule polygons f] calls [f] with the index of each pixel inside ({!Fill.inside}). *)

val count : scene -> unit
(** [count scene] counts an element that is drawn. *)

val enter : scene -> around -> Svg_tree.node -> around
(** [enter scene around node] is around what [node] holds: its style and its transform count. The place of [scene]
    becomes that of [node]. *)

val using : around -> Svg_tree.node -> around
(** [using here node] is [here] where [node] is used. Raises {!Svg_number.Bad} if that leads back to itself. *)

val used : scene -> around -> Svg_tree.node -> (around * Svg_tree.node) option
(** [used scene here node] is what the [use] element [node] draws, and what is around it; [None] if it refers to
    nothing. *)

val rectangle : around -> Svg_tree.node -> size:Svg_tree.node -> Aspect.box
(** [rectangle here node ~size] is the viewport of the element [node]; the width and height of [size] count most.
*)

val fitted : around -> Svg_tree.node -> Aspect.box -> around option
(** [fitted here node box] is around what a viewport holds that is at a box; [None] if nothing can be seen of it.
*)
