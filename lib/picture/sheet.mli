(** A whole SVG file: a drawing with a title above, and what explains it below. *)

val width_limits : int * int
(** The least and the greatest width of a picture, in pixels. *)

val margin : int

val top : title:string option -> int
(** How much is above the drawing. *)

val svg :
  Canvas.t ->
  title:string option -> told:string -> defs:string list -> bar:bool -> key:Key.entry list -> string list -> string
(** [told] is the name of the picture for those who do not see it. Places are rounded to 1/100 of a pixel, which
    the file says. *)
