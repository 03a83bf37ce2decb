(** The state of one run of the service: its limits and the values of its handles. Apart from these, only caches
    last from one request to the next. *)

(** The interface of the service to its process. *)
type surroundings = {
  now : unit -> float;  (** a clock in seconds; only differences count *)
  bounded : 'a. seconds:float -> (unit -> 'a) -> ('a, Fault.stop) result;
  (** calls a function, and stops it if it takes too much time or the program too much memory *)
  passes : exn -> bool;  (** true for exceptions of the process (Ctrl-C), which the service does not catch *)
  read_file : Scc_loading.Loaded.reader;  (** files that a model names, and that are not part of the request *)
}

val quiet : surroundings
(** Surroundings for tests: the clock stands still, nothing is stopped, and there are no files. *)

(** A session. *)
type t = {
  quotas : Quotas.t;
  version : string;  (** of the program *)
  surroundings : surroundings;
  shapes : Shapes.store;
  models : Models.store;
}

val create : ?quotas:Quotas.t -> ?surroundings:surroundings -> version:string -> unit -> t
(** A session without shapes and models. [quotas] (default: {!Quotas.default}) are its limits. *)

val distrust : t -> unit
(** Empties all caches. It must be called after a request that was stopped or failed, which may have left them
    incomplete. *)
