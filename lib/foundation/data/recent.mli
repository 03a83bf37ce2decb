(** A direct-mapped cache, by numbers: one entry for each slot, at the number modulo the size. It begins small,
    and grows up to a bound while many entries are added. Entries may be replaced at any time. *)

type 'a t

val create : number:('a -> int) -> none:'a -> most:int -> 'a t
(** [create ~number ~none ~most] is an empty cache for at most [most] entries, a power of two. [number] is the
    number of an entry. [none] stands in free slots; no query is for its number. *)

val get : 'a t -> int -> 'a
(** The entry in the slot of a number. Compare its number: it may be another entry, or [none]. *)

val keep : 'a t -> 'a -> unit
(** Puts an entry into its slot. *)
