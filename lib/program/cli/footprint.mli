(** The memory of the program, as the system reports it, or the size of the heap if it does not. *)

val resident : unit -> float
(** The bytes in memory, without pages of files, which the system may drop at any time. *)

(** {1 Addresses}

    If the system limits addresses ([ulimit -v], RLIMIT_AS), a program needs more of them than memory. Without any
    left it may be ended within arithmetic or garbage collection. So only a part of them is used; the rest is for
    the steps between two measurements. *)

val is_limited : bool
(** True if the system limits addresses. *)

val told : string option
(** A line that states the limit, for programs that it has stopped. *)

val at_most : int -> int
(** The given number of words of memory, or fewer if there are no addresses for them. *)

val taken : unit -> float
(** The part of the usable addresses that is taken since the start; at 1 there are enough left to end well. It
    is 0 without a limit. *)
