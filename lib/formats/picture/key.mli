(** The explanations below a picture: its colours, its marks and its scale. *)

(** A sample of a colour or mark. *)
type sample =
  | Swatch of { fill : string; stroke : string }
  | Hatch of string  (** the identifier of a pattern *)
  | Glyph of string list  (** elements of SVG in a box of 18 by 12 pixels whose middle is (0, 0) *)

type entry = { sample : sample; text : string }

val rows : left:int -> width:int -> top:int -> entry list -> string list * int
(** The entries in rows within that width, and their height in pixels. *)

type note = { badge : string list;  (** elements of SVG about (0, 0) *) text : string }

val notes : left:int -> width:int -> top:int -> note list -> string list * int
(** The notes one below the other, with as many lines as their texts need, and their height in pixels. *)

val bar : Canvas.t -> left:int -> top:int -> string list
(** A bar of a round length with its number; 32 pixels high. *)
