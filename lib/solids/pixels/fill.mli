(** Filled polygons as pixels. *)

type rule = Nonzero | Even_odd

val polygons : Raster.t -> rule -> colour:int -> Svg_path.polygon list -> unit
(** [polygons picture rule ~colour polygons] paints the pixels whose centres are inside by the rule, exactly,
    in an opaque colour. A centre on an edge is inside if the inside is to the right of it or below. *)
