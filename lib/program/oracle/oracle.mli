(** The service of [specs/oracle.md]: JSON-RPC 2.0, a line in and at most a line out. *)

val methods : string list

(** What answers a request: given the seconds that it may take. Refusals are {!Fault.Refused}. *)
type work = Session.t -> seconds:float -> Read.params -> Reply.t

val handle : ?more:(string * work) list -> Session.t -> string -> string option
(** The answer to a line (without its end), by the {!methods} and [more], on one line without its end; [None] for
    notifications, and for a line of blanks. Whatever the line is, there is no exception, unless the surroundings
    raise one, and the stack that it takes is bounded. *)

val too_long : Session.t -> string
(** The answer to a line beyond the limit [line_bytes]. *)
