(** A source text with its lines. *)

type t

val make : name:string -> string -> t
val name : t -> string
val text : t -> string

val position : t -> int -> int * int
(** [position s offset] is the line and column of a byte offset, both from 1; columns count Unicode code
    points (an invalid byte counts as one). Offsets past the end give the end. *)

val line : t -> int -> string
(** [line s n] is the text of line [n] (from 1) without its line end; [""] when there is none. *)
