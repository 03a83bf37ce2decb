(** What is told below a picture: what its colours and marks mean, and its scale. *)

type sample =
  | Swatch of { fill : string; stroke : string }
  | Hatch of string  (** the identifier of a pattern *)
  | Glyph of string list  (** elements of SVG in a box of 18 by 12 pixels whose middle is (0, 0) *)

type entry = { sample : sample; text : string }

val rows : left:int -> width:int -> top:int -> entry list -> string list * int
(** The entries in as many rows as they take in that width, and how high that is. *)

type note = { badge : string list;  (** elements of SVG about (0, 0) *) text : string }

val notes : left:int -> width:int -> top:int -> note list -> string list * int
(** One below the other, in as many lines as their texts take, and how high that is. *)

val bar : Canvas.t -> left:int -> top:int -> string list
(** A round length with its number; 32 pixels high. *)
