(** The cores of this machine. *)

val available : unit -> int
(** The number of cores that this process may use; 1 if the system does not say. *)
