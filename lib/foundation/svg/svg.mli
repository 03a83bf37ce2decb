(** Elements of SVG as lines of text. Positions are in the units of the picture, y downwards. *)

open Scc_exact

val number : Rat.t -> string
(** [number x] is [x] rounded to two places. *)

val tag : string -> (string * string) list -> string list -> string list
(** [tag name attributes inside] is an element whose lines [inside] are indented. Attribute values are escaped;
    [inside] is not. *)

val text : (string * string) list -> string -> string list
(** [text attributes content] is a [text] element with this content, which is escaped. *)

val title : string -> string list
(** [title text] is a [title] element: browsers show its text while the pointer is over the parent element. It is
    empty for [""]. *)

val closed : (Rat.t * Rat.t) list list -> string
(** [closed polygons] is the data of a path that consists of closed polygons, each given by its corners. *)

val segments : ((Rat.t * Rat.t) * (Rat.t * Rat.t)) list -> string
(** [segments all] is the data of a path that consists of separate segments, each given by its two ends. *)
