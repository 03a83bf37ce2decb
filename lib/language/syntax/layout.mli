(** Laying out a text within a width, with the comments of the source put back where they stood.

    A document is made of pieces, each with the offset in the source of what it prints. Before a piece, the
    comments that stood before that offset are written; so none is lost, and one inside a piece comes after
    it. Laying out the result again gives the same text. *)

type t

val width : int
(** 100 columns, where the pieces allow it. *)

val text : at:int -> string -> t
(** A piece, on one line. [at] is negative for what no source text wrote. *)

val closing : at:int -> string -> t
(** A closing brace: comments before it are indented like the block that it closes. *)

val cat : t list -> t

val space : t
(** A space, or a line end where the group around it is broken. *)

val fill : string -> t
(** These spaces, or a line end if the next piece does not fit. *)

val line : t
(** A line end. *)

val paragraph : t
(** A line end at which an empty line of the source is kept. *)

val nest : int -> t -> t
(** Line ends inside are followed by so many more spaces. *)

val group : t -> t
(** On one line if it fits and no comment stands inside; else broken at its spaces. *)

val render : Trivia.t list -> t -> string
(** The text, its last line ended. The comments are in the order of the source. *)
