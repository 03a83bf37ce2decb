(** Work that is stopped if it takes too much time, or the program too much memory. *)

(** The alarm, with the limit of memory. *)
type t

val create : memory_mib:int -> t
(** Installs the alarm of the program ([SIGALRM]). *)

val working : t -> (unit -> 'a) -> 'a
(** Calls a function during which the alarm rings at intervals; {!bounded} must be called inside it. *)

val bounded : t -> seconds:float -> (unit -> 'a) -> ('a, Scc_oracle.Fault.stop) result
(** Calls a function, and stops it by an exception beyond the limits. Data that it was changing may be
    incomplete and must be discarded. *)
