(** The memory of the program, as the system reports it, or the size of the heap if it does not. *)

val resident : unit -> float
(** The bytes in memory, without pages of files, which the system may drop at any time. *)

(** {1 Limits of the system}

    The system may limit the addresses of a process ([ulimit -v], RLIMIT_AS), of which a program needs more than
    memory, or its data ([ulimit -d], RLIMIT_DATA), of which it needs about as much. Without any left it may be
    ended within arithmetic or garbage collection. So only a part of them is used; the rest is for the steps
    between two measurements. *)

val is_limited : bool
(** True if the system limits addresses or data. *)

val at_most : int -> int
(** The given number of words of memory, or fewer if the limits leave no room for them. *)

val room_below : int -> int option
(** [room_below words] is the limit of the system, in words, that leaves no room for so many. If both limits do, it
    is the one that leaves less. *)

val taken : unit -> float
(** The part of the usable addresses or data that is taken; at 1 there are enough left to end well. It is 0 without
    a limit. *)
