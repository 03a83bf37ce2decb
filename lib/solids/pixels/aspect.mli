(** How the box of a drawing fits into the rectangle in which it is shown: SVG's viewBox and
    preserveAspectRatio. *)

open Scc_exact

type box = { x : Rat.t; y : Rat.t; width : Rat.t; height : Rat.t }

val box : string -> box
(** The value of [viewBox]: four numbers. Raises {!Svg_number.Bad} if there are others, or if a side is
    negative. *)

val fit : string option -> inside:box -> box -> Plane_map.t
(** [fit ratio ~inside box] is the map from the box to the rectangle [inside], by the value of
    [preserveAspectRatio], without which it is [xMidYMid meet]. The box has no side of length 0. Raises
    {!Svg_number.Bad}. *)

val unfit : string option -> inside:box -> box -> box
(** [unfit ratio ~inside box] is what {!fit} takes to [inside]. No side has the length 0. *)

val check : string -> unit
(** [check text] raises {!Svg_number.Bad} if the text is no value of [preserveAspectRatio]. *)
