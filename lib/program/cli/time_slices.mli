(** Work that is given up when it takes too long, or the program too much memory. *)

type t

val create : memory_mib:int -> t
(** Takes the alarm of the program ([SIGALRM]). *)

val working : t -> (unit -> 'a) -> 'a
(** The alarm rings now and then while this is done: {!bounded} is to be called within. *)

val bounded : t -> seconds:float -> (unit -> 'a) -> ('a, Scc_oracle.Fault.stop) result
(** An exception may reach whatever was under way: what is left half made has to be thrown away. *)
