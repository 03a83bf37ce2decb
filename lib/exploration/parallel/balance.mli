(** Of which states the process that has the graph finds the transitions by itself, and which it leaves to others
    ({!Crew}): by what it costs to find them, to tell others of states and to hear of them, and by who waits for
    whom. All is measured while it goes on; nothing that is found depends on it. *)

type t

val create : now:(unit -> float) -> t
(** [now] is a clock, in seconds. *)

(** {1 What is measured} *)

val finding : t -> (unit -> 'a) -> 'a
(** Finds the transitions of one state here. *)

val pays : t -> bool
(** What has been found here takes so long that others may be of use. *)

val telling : t -> (unit -> 'a) -> 'a
(** Makes a request of some states. What a system takes to carry it does not count: it is much for a request of few
    states, and requests have few where few are told. *)

val hearing : t -> int -> (unit -> 'a) -> 'a
(** Hears of one state, of this number. *)

val waited : t -> unit
(** This process had nothing to do. *)

val answered : t -> states:int -> waited:float -> worked:float -> unit
(** Another process has found the transitions of so many states in [worked] seconds, and had nothing to do for
    [waited] seconds before. *)

(** {1 What follows} *)

val is_here : t -> int -> bool
(** The state of this number is left to this process, if others have nothing to do yet. *)

val batch : t -> int
(** How many states are to be in a request at most. *)

val least : t -> int
(** How many at least, to a process that has nothing to do. *)

val least_ahead : t -> int
(** How many at least, to one that has something to do. *)

val between_looks : t -> int
(** After how many states one looks whether something has come. *)
