(** A whole SVG file: a drawing with a title above and explanations below. *)

val width_limits : int * int
(** The least and the greatest width of a picture, in pixels. *)

val margin : int
(** The margin around the drawing, in pixels. *)

val top : title:string option -> int
(** The space above the drawing, in pixels. *)

(** The file around a drawing. *)
type t = {
  size : int * int;  (** of the drawing with the space above it, in pixels *)
  title : string option;
  told : string;  (** the name of the picture, for screen readers *)
  defs : string list;
  bar : Canvas.t option;  (** the canvas of the drawing, for a scale *)
  key : Key.entry list;
  notes : Key.note list;
}

val svg : t -> string list -> string
(** The text of the file, given the elements of the drawing. Places are rounded to 1/100 of a pixel, and the
    file says so. *)
