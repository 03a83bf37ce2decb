(** A cache of the few entries that were added last. An entry is found by comparing it with each of them. *)

type 'a t

val create : most:int -> 'a t
(** An empty cache for [most] entries, at least one. *)

val find : 'a t -> ('a -> bool) -> 'a option
(** [find t is] is the last entry for which [is] is true. *)

val keep : 'a t -> 'a -> unit
(** Adds an entry. The oldest entry makes room for it if the cache is full. *)

val retain : 'a t -> ('a -> bool) -> unit
(** [retain t is] drops the entries for which [is] is false. *)
