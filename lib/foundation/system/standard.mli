(** Writing to standard output and standard error.

    It replaces the channels of OCaml. A channel tries again at the end of the program to write what it could not
    write, and an error of that would change the exit code. *)

exception Closed
(** The reader of the output has closed it, or has read nothing for two seconds after a request to end the program.
*)

exception Failed of string
(** Standard output cannot be written, for this reason. *)

val print : string -> unit
(** [print text] buffers [text] for standard output, until {!flush} or until the buffer has 64 KiB. It raises
    {!Closed} or {!Failed}; after either of them all output is dropped. *)

val print_buffer : Buffer.t -> unit
(** [print_buffer buffer] writes all contents of a buffer to standard output at once. {!Closed}, {!Failed}. *)

val flush : unit -> unit
(** [flush ()] writes what {!print} has buffered. {!Closed}, {!Failed}. *)

val withdraw : unit -> bool
(** [withdraw ()] drops what is buffered. It returns true if nothing was ever written; otherwise all later output
    is dropped too. *)

val complain : string -> unit
(** [complain text] writes [text] to standard error at once, with control characters written out by
    {!Scc_base.Visible.text}. It ignores errors: where standard error cannot be written, nothing can be reported.
*)

val control : string -> unit
(** [control bytes] writes bytes as they are to standard error at once: for sequences that control a terminal, and
    for texts that have colours and are {!Scc_base.Visible} already. It ignores errors. *)
