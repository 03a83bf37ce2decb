(** Things of which the least can be taken out. It is ours since no library that is packaged everywhere lets
    floats stand before exact keys, without which the times of events are slow to compare. *)

type 'a t

val create : near:('a -> float) -> compare:('a -> 'a -> int) -> 'a t
(** In the order of [compare]. [near] is asked once for each and compared first, so it must never be in another
    order: [compare x y <= 0] implies [near x <= near y]. Rounding a number to the nearest float is so, and so is
    a constant. *)

val size : 'a t -> int
val add : 'a t -> 'a -> unit

val first : 'a t -> 'a option
(** One that is least; of several, which one is not said, but it is the same in every run. *)

val drop_first : 'a t -> unit
(** Does nothing when there is none. *)

val take : 'a t -> 'a option
(** The {!first} one, which leaves. *)

val keep : 'a t -> ('a -> bool) -> unit
(** Drops all others, in linear time. *)
