(** Sets of numbers from 0 to n - 1, a bit for each of these. *)

type t

val create : int -> t
(** The empty set of numbers below n. *)

val init : int -> (int -> bool) -> t
(** Those below n that pass the test. *)

val mem : t -> int -> bool
val add : t -> int -> unit
val remove : t -> int -> unit

val is_empty : t -> bool
(** In linear time. *)
