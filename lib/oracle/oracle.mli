(** The service of [specs/oracle.md]: JSON-RPC 2.0, a line in and at most a line out. *)

val methods : string list

val handle : Session.t -> string -> string option
(** The answer to a line (without its end), on one line without its end; [None] for notifications, and for a line
    of blanks. Whatever the line is, there is no exception, unless the surroundings raise one, and the stack that
    it takes is bounded. *)

val too_long : Session.t -> string
(** The answer to a line beyond the limit [line_bytes]. *)
