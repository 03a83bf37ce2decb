(** Numbers and lists of words in the attributes of SVG. *)

open Scc_exact

exception Bad of string
(** An attribute that violates the format; the text is the reason. *)

exception Unread of string
(** An attribute with a feature that is not supported; the text names it. *)

exception Beyond of string
(** A drawing beyond a limit; the text says of what it has more, with the number. *)

type cursor = { text : string; mutable at : int; mutable first : bool  (** no comma may stand here *) }
(** A place in a text. *)

val cursor : string -> cursor
(** The start of a text. *)

val is_blank : char -> bool
(** [is_blank c] is true for the blanks of XML and CSS. *)

val ended : cursor -> bool
(** [ended c] skips blanks, and is true if nothing follows. *)

val skip : cursor -> unit
(** [skip c] skips blanks and, if it is not the first word, at most one comma. *)

val number : cursor -> Rat.t
(** The next number, exactly, after {!skip}. It has at most 40 characters and an exponent of at most 10{^±9}. *)

val flag : cursor -> bool
(** The next flag, 0 or 1, after {!skip}. It need not be separated from the text after it. *)

val all : string -> Rat.t list
(** All numbers of a text, at most a million, with blanks or one comma between them. *)

val words : string -> string list
(** The words of a text, with blanks or one comma between them. *)

val with_unit : string -> Rat.t * string
(** A number of CSS and its unit, in small letters, which may be empty. Nothing else is in the text but blanks
    around both. *)

val length : ?whole:Rat.t -> string -> Rat.t
(** A number with a unit, in pixels: an inch has 96 pixels. Percentages are of [whole], if that is given. *)

val share : string -> Rat.t
(** The share from 0 to 1 of a text, a number or a percentage. *)
