(** The words of the language ([language_words.txt]). *)

val is_reserved : string -> bool
(** [is_reserved word] is true for a word of the language that cannot name a feature wherever one is named. *)
