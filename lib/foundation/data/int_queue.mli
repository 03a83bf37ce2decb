(** Queues of integers, first in, first out, of 8 bytes for each. *)

type t

val create : unit -> t
(** [create ()] is a new empty queue. *)

val length : t -> int
(** [length q] is the number of integers in the queue. *)

val push : t -> int -> unit
(** [push q x] appends [x], in constant time. *)

val take : t -> int option
(** [take q] is the oldest integer, which it removes, in constant time; [None] if the queue is empty. *)
