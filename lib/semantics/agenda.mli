(** What is to come, in order of exact times: a heap. *)

open Scc_exact

type 'a t

val create : ('a -> Rat.t) -> 'a t
(** By the time of each. *)

val size : 'a t -> int
val add : 'a t -> 'a -> unit

val first : 'a t -> 'a option
(** One with the least time; of several, which one is not said, but it is the same in every run. *)

val drop_first : 'a t -> unit
(** Does nothing when there is none. *)

val keep : 'a t -> ('a -> bool) -> unit
(** Drops all others, in linear time. *)
