(** Characters that change the direction in which a text is shown: U+202A to U+202E and U+2066 to U+2069 (Unicode
    Standard Annex 9), in UTF-8.

    Where they stand, the text that is seen is not the text that is read; compilers warn of them. Marks (U+061C,
    U+200E, U+200F) are not among them: they move only neutral characters beside them. *)

val size : int
(** The bytes of each of them in UTF-8: 3. *)

val at : string -> int -> int option
(** [at text i] is the code point of the one that begins at byte [i], if any. [i] is an index of the text. *)

val next : string -> int -> (int * int) option
(** [next text i] is the offset and the code point of the first one that begins at byte [i] or after it. *)

val named : int -> string
(** [named code] is the code point in Unicode notation: ["U+202E"]. *)
