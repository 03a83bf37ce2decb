(** The server of [scc serve], on the loopback alone. What it answers to whom is told in
    [lib/program/serve/README.md]. *)

type how = {
  desk : Desk.t;
  port : int option;  (** any that is free, if none is asked for *)
  desk_process : string array;  (** the arguments of a process that helps who writes *)
  document_process : check:Scc_exchange.Json.t -> seconds:float option -> (string array, string) result;
  (** those of one that makes a document, given what a request says is to be checked; or what is wrong with that *)
  listening : string -> unit;  (** is told the address once it is there *)
}

val run : how -> (unit, string) result
(** Serves until SIGINT or SIGTERM; then all processes are ended. The error: it cannot listen. *)
