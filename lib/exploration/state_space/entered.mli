(** A set of numbers that only grows: one process puts them in, and all may look. *)

type t

val create : unit -> t
(** [create ()] is an empty set. *)

val note : t -> int -> bool
(** [note t number] puts a number in, and is true if it was not there. *)

val mem : t -> int -> bool
(** [mem t number] is true if the number is in the set. Of a set that is shared, another process may not know yet
    what has just been put in. *)

val share : t -> bool
(** [share t] moves the set into memory that is shared with processes that are forked afterwards. It is false, and
    nothing has changed, if the system gives no such memory. *)
