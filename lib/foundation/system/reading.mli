(** Opening files, for reading or writing, and reading from sources that may have to be waited for: files, pipes,
    terminals. A signal does not end a wait for data, unless its handler raises an exception or a request to end
    the program is due ({!Interruption.check}). A wait for the other end of a named pipe ends at the first signal
    after a request to end the program, even if a handler is installed ({!Interruption.break_off}). *)

val open_file : string -> Unix.file_descr
(** [open_file path] opens a file for reading. A named pipe is waited for until another process opens it for
    writing. [Unix.Unix_error]. *)

val create_file : string -> Unix.open_flag list -> int -> Unix.file_descr
(** [create_file path flags mode] opens a file with these flags and permissions, closed on [exec]. A named pipe is
    waited for until another process opens its other end. [Unix.Unix_error]. *)

val some : Unix.file_descr -> bytes -> int -> int -> int
(** [some file bytes from most] reads at least one and at most [most] bytes to offset [from] of [bytes]. It returns
    how many, which is 0 at the end. It waits for data even if the descriptor is non-blocking. [Unix.Unix_error].
*)

exception Failed of string
(** Standard input cannot be read, for this reason. *)

val input : bytes -> int -> int -> int
(** [input bytes from most] is {!some} for standard input. Errors of the system raise {!Failed}. *)
