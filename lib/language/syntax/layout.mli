(** Layout of a text within a width, with the comments of the source in their old places.

    A document consists of pieces, each with the offset in the source of what it prints. The comments that stood
    before that offset are written before the piece. So no comment is lost, and a comment inside a piece follows
    it. Laying out the result again gives the same text. *)

(** A document: pieces, spaces and line ends, nested and grouped. *)
type t

val text : at:int -> string -> t
(** [text ~at s] is the piece [s] on one line. [at] is its offset in the source, or negative if the source has
    no such text. *)

val closing : at:int -> string -> t
(** [closing ~at s] is a closing brace. Comments before it have the indentation of the block that it closes. *)

val cat : t list -> t
(** [cat ds] is the documents one after another, with nothing between them. *)

val space : t
(** A space, or a line end if the group around it is broken. *)

val fill : string -> t
(** [fill s] is the spaces [s], or a line end if the next piece does not fit on the line. *)

val line : t
(** A line end. *)

val paragraph : t
(** A line end at which an empty line of the source is kept. *)

val nest : int -> t -> t
(** [nest n d] is [d] with [n] more spaces of indentation after the line ends inside it. *)

val group : t -> t
(** [group d] is [d] on one line if it fits and no comment stands inside. Otherwise its spaces become line
    ends. *)

val render : Trivia.t list -> t -> string
(** [render trivia d] is the text of [d] with the comments [trivia], which are in the order of the source. A
    text that is not empty ends with a line end. *)
