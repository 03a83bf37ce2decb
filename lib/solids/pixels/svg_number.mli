(** Numbers and lists of words in the attributes of SVG. *)

open Scc_exact

exception Bad of string
(** An attribute that violates the format; the text is the reason. *)

exception Unread of string
(** An attribute with a feature that is not supported; the text names it. *)

type cursor = { text : string; mutable at : int }

val is_blank : char -> bool
(** [is_blank c] is true for the blanks of XML and CSS. *)

val ended : cursor -> bool
(** [ended c] skips blanks and commas, and is true if nothing follows. *)

val number : cursor -> Rat.t
(** The next number, exactly, after blanks and commas. It has at most 40 characters and an exponent of at most
    10{^±9}. *)

val flag : cursor -> bool
(** The next flag, 0 or 1, after blanks and commas. It need not be separated from the text after it. *)

val all : string -> Rat.t list
(** All numbers of a text, at most a million. *)

val length : ?whole:Rat.t -> string -> Rat.t
(** A number with a unit, in pixels: an inch has 96 pixels. Percentages are of [whole], if that is given. *)
