(** Tasks that do not depend on each other, worked on by several processes; what comes of them is taken up in
    order.

    Processes, and not threads, so that all of this works with OCaml 4.13 to 5.3 and nothing is shared. Task k is
    worked on by process k mod n; a process that is far ahead waits until what it has found is asked for.

    A process that dies is replaced by another one, which goes on with the task that was lost: nothing but time is
    lost. Where the system gives fewer processes or descriptors than were asked for, fewer work; where it gives
    none, this one works alone, and an interruption ends it after the task that is under way. *)

type stop =
  | Interrupted
  | Lost of { task : int; how : string; fault : bool }
  (** The task that brought its process to an end, {!most_deaths} times or by an exception, and how, as a sentence
      about "it". [fault]: the program is wrong, and not short of memory or ended from outside. *)

val most_deaths : int
(** So many processes in a row may be lost over one task. *)

val run :
  jobs:int ->
  first:int ->
  count:int ->
  work:(int -> 'a) ->
  interrupted:(unit -> bool) ->
  each:(int -> 'a -> unit) ->
  (unit, stop) result
(** Tasks [first] to [count] - 1. [work] is called in another process, also of one, so that a task that takes long
    can be left, and may be called again for a task whose process died. What it gives must be something that
    {!Marshal} takes. An exception of it ends all, at its task. [each] is called in this process, by
    increasing numbers, and for no task after the one at which it stops. Nothing that was printed before is printed
    twice, if it was flushed. *)
