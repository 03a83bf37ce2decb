(** Filled polygons as pixels. *)

type rule = Nonzero | Even_odd

val polygons : Raster.t -> rule -> colour:int -> Svg_path.polygon list -> unit
(** Makes opaque, in that colour, the pixels whose centres are within by the rule, exactly; of centres on the line
    those of which the inside is to the right or below. *)
