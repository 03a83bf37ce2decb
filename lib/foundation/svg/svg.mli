(** Elements of SVG as lines of text. Positions are in the units of the picture, y downwards. *)

open Scc_exact

val escape : string -> string
(** Text of an element or of an attribute, in UTF-8.
    It is shown as {!Scc_base.Visible.text} shows it: XML has no control characters. *)

val number : Rat.t -> string
(** Rounded to two places. *)

val tag : string -> (string * string) list -> string list -> string list
(** An element with attributes (which it escapes) and what is in it, indented. *)

val text : (string * string) list -> string -> string list
(** A [text] element with that text. *)

val title : string -> string list
(** What is shown while the pointer is over the element that it is in; nothing for [""]. *)

val closed : (Rat.t * Rat.t) list list -> string
(** The data of a path: polygons. *)

val segments : ((Rat.t * Rat.t) * (Rat.t * Rat.t)) list -> string
(** Of one that consists of segments. *)
