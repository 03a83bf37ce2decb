(** A whole SVG file: a drawing with a title above, and what explains it below. *)

val width_limits : int * int
(** The least and the greatest width of a picture, in pixels. *)

val margin : int

val top : title:string option -> int
(** How much is above the drawing. *)

type t = {
  size : int * int;  (** of the drawing, with what is above it *)
  title : string option;
  told : string;  (** the name of the picture for those who do not see it *)
  defs : string list;
  bar : Canvas.t option;  (** a scale for what is drawn on this *)
  key : Key.entry list;
  notes : Key.note list;
}

val svg : t -> string list -> string
(** The file around a drawing. Places are rounded to 1/100 of a pixel, which it says. *)
