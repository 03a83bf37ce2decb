(** The signs of sets that the original notation has and the language of scc has not. *)

val spelt : string -> string
(** The text with [∪], [∩] and [∖] as [+], [*] and [-], outside of comments and strings. Each takes as many
    bytes as the sign, so that everything keeps its place. *)

val length : string -> int -> int
(** How many bytes of the text the mark has that {!spelt} has a [+], [*] or [-] for at this place. *)
