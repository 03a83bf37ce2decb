(** Numbers from 0 to n - 1 that wait to be looked at, first in, first out: each enters once. *)

type t

val create : int -> t

val add : t -> int -> unit
(** Does nothing when it has been added before, also when it has left since. *)

val mem : t -> int -> bool
(** Whether it has ever been added. *)

val run : t -> (int -> unit) -> unit
(** Takes them out one by one until none waits; the function may add others. *)
