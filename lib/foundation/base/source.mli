(** A source text with its lines. *)

type t

val make : name:string -> string -> t
(** [make ~name text] is a source with the beginnings of its lines found. A line ends with a line feed; offsets
    count bytes from 0. *)

val name : t -> string
(** The name given to {!make}: that of the file, as spans have it. *)

val text : t -> string
(** The whole text, with any byte order mark. *)

val position : t -> int -> int * int
(** [position s offset] is the line and column of a byte offset, both from 1. Columns count Unicode code points:
    each byte counts as one, unless it has the form of a continuation byte. A byte order mark at the beginning does
    not count. An offset past the end gives the position of the end. *)

val line : t -> int -> string
(** [line s n] is the text of line [n] (from 1) without its line end, and without a byte order mark. It is [""] if
    there is no such line. *)

(** {1 Byte order marks}

    Some editors put a byte order mark (of UTF-8, 3 bytes) before any text. *)

val after_mark : string -> int
(** [after_mark text] is the offset at which the text proper begins: 3 after a byte order mark, and 0 without one.
*)

val blank_mark : string -> string
(** [blank_mark text] is the text with three blanks in place of a byte order mark, so that all offsets stay valid.
*)
