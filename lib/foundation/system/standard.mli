(** Writing to standard output and standard error.

    The channels of OCaml are not used for them: what these could not write they try again at the end of the
    program, and an error there would be its exit code. *)

exception Closed
(** Nobody reads what is written. *)

exception Failed of string
(** Standard output cannot be written, for this reason. *)

val print : string -> unit
(** To standard output, at {!flush} or when there is much of it. {!Closed}, {!Failed}: what is printed after one of
    them is dropped. *)

val print_buffer : Buffer.t -> unit
(** All that is in a buffer, at once. {!Closed}, {!Failed}. *)

val flush : unit -> unit
(** Sends off what was printed. {!Closed}, {!Failed}. *)

val withdraw : unit -> bool
(** Drops what was printed and not sent off. Whether that is all that ever was printed. *)

val complain : string -> unit
(** To standard error, at once, as {!Scc_base.Visible.text} shows it. Where that cannot be written nothing can be
    told: no error either. *)

val control : string -> unit
(** The same of bytes as they are: for what controls a terminal, and for texts that are {!Scc_base.Visible} and
    have colours. *)
