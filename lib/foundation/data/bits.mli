(** Sets of numbers from 0 to n - 1, with one bit for each number. Indices must be in this range; a byte outside of
    the set is an error ([Invalid_argument]). *)

type t

val create : int -> t
(** [create n] is the empty set of numbers below [n]. *)

val init : int -> (int -> bool) -> t
(** [init n test] is the set of the numbers below [n] that pass [test], called in increasing order. *)

val mem : t -> int -> bool
(** [mem s i] is true if [i] is in the set. *)

val add : t -> int -> unit
(** [add s i] puts [i] into the set. *)

val remove : t -> int -> unit
(** [remove s i] takes [i] out of the set. *)

val is_empty : t -> bool
(** [is_empty s] is true if the set has no element. It takes time linear in [n]. *)
