(** Priority queues, as heaps in which each node has four children.

    The module is our own, since no library that is packaged everywhere compares a float before the exact key.
    Without that, the exact times of events are slow to compare. *)

type 'a t

val create : near:('a -> float) -> compare:('a -> 'a -> int) -> 'a t
(** [create ~near ~compare] is an empty heap in the order of [compare]. [near] is called once for each entry, and
    its floats are compared first. So [near] must be monotone: [compare x y <= 0] implies [near x <= near y].
    Rounding to the nearest float is monotone, and so is a constant. *)

val size : 'a t -> int
(** [size h] is the number of entries. *)

val add : 'a t -> 'a -> unit
(** [add h x] inserts [x], in logarithmic time. *)

val first : 'a t -> 'a option
(** [first h] is a least entry, in constant time; [None] if the heap is empty. Of several least entries it is not
    specified which one, but it is the same in every run. *)

val drop_first : 'a t -> unit
(** [drop_first h] removes {!first}, in logarithmic time. An empty heap stays as it is. *)

val take : 'a t -> 'a option
(** [take h] is {!first}, which it removes. *)

val keep : 'a t -> ('a -> bool) -> unit
(** [keep h wanted] removes all entries that do not pass [wanted], in linear time. *)
