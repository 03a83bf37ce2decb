(** The files of the project, by their paths from its root. *)

val exists : string -> bool
(** Of a file or folder. *)

val read : string -> string
(** The bytes of a file; empty when there is none. *)

val files : string -> string list
(** [files folder] lists every source file under [folder], sorted: names that begin with a dot, and folders
    [_build], are left out. A file that vanishes meanwhile is left out as well. *)

val contains : string -> string -> bool
(** [contains text part]. *)

val places : string -> string -> int list
(** [places text part]: where [part] begins in [text], from left to right. *)

val starts_with : string -> string -> bool
(** [starts_with part text]. *)

val quoted_after : string -> string -> string list
(** [quoted_after prefix text]: each string literal that begins with [prefix], whole. *)

val words_after : string -> string -> string list
(** [words_after prefix text]: for each occurrence of [prefix] at the start of a word, the word that it
    continues with: letters, digits and [_.-], without a final dot or hyphen. *)
