(** Characters that change the direction in which a text is shown: U+202A to U+202E and U+2066 to U+2069 (Unicode
    Standard Annex 9), in UTF-8. Where they stand, what is seen is not what is read; compilers warn of them. Marks
    (U+061C, U+200E, U+200F), which move only what is neutral beside them, are not among them. *)

val size : int
(** Bytes of each of them in UTF-8. *)

val at : string -> int -> int option
(** The code point, if one of them begins at that byte. *)

val next : string -> int -> (int * int) option
(** The first one that begins at an offset or after it: where, and its code point. *)

val named : int -> string
(** ["U+202E"]. *)
