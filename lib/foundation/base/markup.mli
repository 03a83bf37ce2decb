(** Characters in XML and HTML. *)

val add : Buffer.t -> char -> unit
(** [add b c] adds [c] to [b], or the reference that stands for [<], [>], [&] or a quotation mark. *)
