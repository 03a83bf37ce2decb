(** Texts as XML writes them, with references for special characters. *)

val attribute : string -> string
(** The value of an attribute, in quotes. *)

val content : string -> string
(** The text in an element. *)

val only_characters : string -> string
(** The text with a space for each character that XML does not have: control characters except tab and line
    ends, U+FFFE and U+FFFF. *)

val is_text : string -> bool
(** [is_text s] is true if XML has all characters of [s]. *)
