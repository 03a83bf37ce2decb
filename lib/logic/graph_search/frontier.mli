(** Queues of the states that wait to be expanded, in one of two orders. *)

open Scc_exact

type t

val by_steps : unit -> t
(** [by_steps ()] is an empty queue, first in, first out. *)

val by_time : unit -> t
(** [by_time ()] is an empty queue in the order of times; states of one time leave first in, first out. *)

val push : t -> int -> Rat.t -> unit
(** [push q i time] inserts state [i] with its earliest arrival. {!by_steps} ignores the time. *)

val take : t -> int option
(** [take q] is the state at the head, which it removes; [None] if the queue is empty. *)

val length : t -> int
(** [length q] is the number of entries. *)

val iter : (int -> unit) -> t -> unit
(** [iter f q] calls [f] for each entry, in the order of the queue. *)
