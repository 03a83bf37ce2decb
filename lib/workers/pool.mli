(** Tasks that do not depend on each other, worked on by several processes; what comes of them is taken up in
    order.

    Processes, and not threads, so that all of this works with OCaml 4.13 to 5.3 and nothing is shared. Task k is
    worked on by process k mod n; a process that is far ahead waits until what it has found is asked for. *)

type stop =
  | Interrupted
  | Lost of { task : int; how : string }  (** the process that worked on it came to an end, and how *)

val run :
  jobs:int ->
  first:int ->
  count:int ->
  work:(int -> 'a) ->
  interrupted:(unit -> bool) ->
  each:(int -> 'a -> unit) ->
  (unit, stop) result
(** Tasks [first] to [count] - 1. [work] is called in another process, also of one, so that a task that takes long
    can be left; what it gives must be
    something that {!Marshal} takes; an exception of it is a process lost. [each] is called in this one, by
    increasing numbers, and for no task after the one at which it stops. Nothing that was printed before is printed
    twice, if it was flushed. *)
