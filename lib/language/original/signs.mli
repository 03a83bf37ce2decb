(** The signs of sets, which are part of the original notation and not of the language of scc. *)

val spelt : string -> string
(** [spelt text] has [+], [*] and [-] in place of [∪], [∩] and [∖], outside of comments and strings. Spaces fill
    up the bytes of the sign, so that everything keeps its place. *)

val length : string -> int -> int
(** [length text i] is the number of bytes of the mark at [i] in the original text, where {!spelt} has a [+],
    [*] or [-]. *)
