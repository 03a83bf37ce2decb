(** Warnings of texts that are not what they look like: {!Bidirectional}. *)

val warnings : Source.t -> Diag.t list
(** Where they are in a text: one warning (SC0113) for each line, of the first 20 such lines, and then one for all
    that follow. Of what is no text, such as a mesh in binary, nothing is said. *)
