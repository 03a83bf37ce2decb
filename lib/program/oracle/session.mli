(** What one run of the service knows: its limits, and what its handles stand for. Nothing else lasts from one
    request to the next but what only saves time. *)

(** How the service talks to its surroundings. *)
type surroundings = {
  now : unit -> float;  (** a clock in seconds; only differences count *)
  bounded : 'a. seconds:float -> (unit -> 'a) -> ('a, Fault.stop) result;
  (** does something, or gives it up when it takes more time, or the program more memory, than there is *)
  passes : exn -> bool;  (** an exception of theirs (Ctrl-C), which no request stops *)
  read_file : Scc_session.Loaded.reader;  (** files that a model names, and that are not part of the request *)
}

val quiet : surroundings
(** A clock that stands still, nothing is given up, and there are no files. *)

type t = {
  quotas : Quotas.t;
  version : string;  (** of the program *)
  surroundings : surroundings;
  shapes : Shapes.store;
  models : Models.store;
}

val create : ?quotas:Quotas.t -> ?surroundings:surroundings -> version:string -> unit -> t

val distrust : t -> unit
(** After a request that was given up or failed: what only saves time may have been left half made, and is
    forgotten. *)
