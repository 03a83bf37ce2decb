(** The server of [scc serve], on the loopback interface alone. Its requests and answers are listed in
    [lib/program/serve/README.md]. *)

(** The configuration of a server. *)
type how = {
  desk : Desk.t;
  port : int option;  (** [None]: any free port *)
  desk_process : string array;  (** the arguments of the process that helps the editor *)
  document_process : check:Scc_json.Json.t -> seconds:float option -> (string array, string) result;
  (** the arguments of a process that makes a document, by the member [check] of a request; or its error *)
  listening : string -> unit;  (** is called with the address once the server listens *)
}

val run : how -> (unit, string) result
(** Serves until SIGINT or SIGTERM, and then ends all processes. The error is the reason why it cannot
    listen. *)
