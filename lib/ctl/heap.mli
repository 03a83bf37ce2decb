(** A binary heap of numbers with keys; the least key comes first. *)

type 'key t

val create : compare:('key -> 'key -> int) -> 'key -> 'key t
(** Any key, to fill places that are not used yet. *)

val push : 'key t -> 'key -> int -> unit
val pop : 'key t -> ('key * int) option
