(** The edges without duration of some states of a graph that keeps no edges: the first ones that are told, so many
    that they take little memory. *)

type t

val create : unit -> t

val keep : t -> int -> ((int -> int -> unit) -> unit) -> unit
(** [keep t i each]: those of a state, once; [each put] tells of them in order, each as its place among all edges
    of the state, and its target. *)

val find : t -> int -> (int * int) list option
(** Places and targets. [None]: they are not kept, or there are none. *)

val bytes : t -> int
