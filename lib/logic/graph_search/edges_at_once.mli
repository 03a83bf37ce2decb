(** A cache of edges without duration, for a graph that keeps no edges. It takes the first 262 144 numbers that it
    is given, and then no more states, so that it takes little memory. *)

type t

val create : unit -> t
(** [create ()] is an empty cache. *)

val keep : t -> int -> ((int -> int -> unit) -> unit) -> unit
(** [keep t i each] stores the edges without duration of state [i], once. [each put] calls [put place target] for
    each of them in order; the place is the index among all edges of the state. *)

val find : t -> int -> (int * int) list option
(** [find t i] is the places and targets of these edges of state [i]. It is [None] if they are not stored, or if
    there are none. *)

val bytes : t -> int
(** [bytes t] is about how much memory the cache takes, in bytes. *)
