(** Pieces of XML. *)

val quoted : string -> string
(** A text as the value of an attribute, with its quotes. What XML cannot hold becomes U+FFFD. *)

val name : string -> string
(** The words of a text as one name of letters, digits, [_] and [-]: not the same for every text. *)
