(** The cores of this machine. *)

val available : unit -> int
(** Those that this process may use; 1 where the system does not tell. *)
