(** Reading what others may have to write first: files, pipes, terminals. A signal breaks nothing off, unless its
    handler raises an exception. *)

val open_file : string -> Unix.file_descr
(** For reading; a named pipe is waited for until somebody writes. [Unix.Unix_error]. *)

val create_file : string -> Unix.open_flag list -> int -> Unix.file_descr
(** With these flags and permissions; a named pipe is waited for until somebody reads. [Unix.Unix_error]. *)

val some : Unix.file_descr -> bytes -> int -> int -> int
(** [some file bytes from most] reads at most so many bytes to this place, at least one, or 0 at the end. It waits
    for them even where a file would rather tell that there are none. [Unix.Unix_error]. *)

exception Failed of string
(** Standard input cannot be read, for this reason. *)

val input : bytes -> int -> int -> int
(** {!some} of standard input. {!Failed}. *)
