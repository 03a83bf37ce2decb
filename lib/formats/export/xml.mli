(** Pieces of XML. *)

val quoted : string -> string
(** A text as the value of an attribute, with its quotes. A character that XML does not have becomes U+FFFD. *)

val name : string -> string
(** The words of a text as one name of letters, digits, [_] and [-]. Different texts may have one name. *)
