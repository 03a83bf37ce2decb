(** A source text with its lines. *)

type t

val make : name:string -> string -> t
val name : t -> string
val text : t -> string

val position : t -> int -> int * int
(** [position s offset] is the line and column of a byte offset, both from 1; columns count Unicode code
    points (an invalid byte counts as one; a byte order mark at the beginning is none). Offsets past the end give
    the end. *)

val line : t -> int -> string
(** [line s n] is the text of line [n] (from 1) without its line end, and without a byte order mark; [""] when
    there is none. *)

(** {1 Byte order marks}

    Some editors put one (of UTF-8) before any text. *)

val after_mark : string -> int
(** Where the text begins that may have one: at 3 or 0. *)

val blank_mark : string -> string
(** The text with blanks instead, so that everything keeps its place. *)
