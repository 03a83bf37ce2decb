(** Worklists of the numbers from 0 to n - 1: queues, first in, first out, which each number enters at most once.
*)

type t

val create : int -> t
(** [create n] is an empty worklist of the numbers below [n]. *)

val add : t -> int -> unit
(** [add w i] appends [i], unless it was added before, even if it was taken out since. *)

val mem : t -> int -> bool
(** [mem w i] is true if [i] has ever been added. *)

val run : t -> (int -> unit) -> unit
(** [run w visit] takes the numbers out in order and calls [visit] for each, until the list is empty. [visit] may
    add numbers. *)
