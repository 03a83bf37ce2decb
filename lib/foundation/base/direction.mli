(** Warnings of texts in which characters that change direction ({!Bidirectional}) show another text than is read.
*)

val warnings : Source.t -> Diag.t list
(** [warnings source] is one warning (SC0113) for each line with such a character, for the first 20 such lines, and
    one more for all that follow. It is empty for data that are not text, such as a mesh in binary. *)
