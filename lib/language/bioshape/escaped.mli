(** Texts as XML writes them. *)

val attribute : string -> string
(** In quotes. *)

val content : string -> string

val only_characters : string -> string
(** With spaces for what no character of XML is (a form feed; U+FFFE and U+FFFF). *)

val is_text : string -> bool
(** Nothing of that is in it. *)
