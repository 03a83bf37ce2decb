(** The service of [specs/oracle.md]: JSON-RPC 2.0, a line in and at most a line out. *)

(** An implementation of a method. [seconds] is the time that it may take. It may raise {!Fault.Refused}. *)
type work = Session.t -> seconds:float -> Read.params -> Reply.t

val handle : ?more:(string * work) list -> Session.t -> string -> string option
(** The answer to a line, without line ends, by its methods and [more]. It is [None] for notifications and
    for blank lines. No line causes an exception, except one that the surroundings pass on, and the stack is
    bounded. *)

val schema_file : Scc_json.Json_schema.file
(** The schema of the messages. The params and results of methods are definitions of it. *)

val too_long : Session.t -> string
(** The answer to a line beyond the limit [line_bytes]. *)
