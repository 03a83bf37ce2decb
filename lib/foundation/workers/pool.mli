(** A pool of worker processes for independent tasks. Their results are handled in the order of the tasks.

    Workers are processes and not threads, so that all of this works with OCaml 4.13 to 5.3 and nothing is shared.
    The tasks are dealt out in turn: task [first + k] goes to worker k mod n. A worker that is far ahead waits
    until its results are read.

    A worker that dies is replaced by another one, which goes on with the task that was lost: only time is lost. If
    the system gives fewer processes or descriptors than [jobs], the pool is smaller. If it gives none, this
    process works alone, and an interruption ends it after the present task. *)

type stop =
  | Interrupted
  | Lost of { task : int; how : string; fault : bool }
  (** The task that failed. Its work raised an exception, or its worker died {!most_deaths} times in a row, or no
      process could replace a worker that died. [how] says how, in a clause that calls the task [it]. [fault] is
      true for an error of the program itself, and false for a lack of memory or an end from outside. *)

val most_deaths : int
(** 10: the number of workers in a row that one task may bring to an end before the pool gives up. *)

val run :
  ?patience:float ->
  jobs:int ->
  first:int ->
  count:int ->
  work:(int -> 'a) ->
  interrupted:(unit -> bool) ->
  each:(int -> 'a -> unit) ->
  unit ->
  (unit, stop) result
(** [run ~jobs ~first ~count ~work ~interrupted ~each ()] works on the tasks [first] to [count - 1] with [jobs]
    workers.

    [work] is called in a worker, even if [jobs] is 1, so that a long task can be abandoned. It may be called again
    for a task whose worker died. [Marshal] must accept its results. An exception of it ends the run at its task,
    but [Out_of_memory] in a worker counts as the death of the worker.

    [each] is called in this process, with the task and its result, by increasing tasks, up to the task at which
    the run stops. [interrupted] is called a few times a second; when it is true the run stops. Output that was
    flushed before is not printed twice.

    When the run stops, workers are killed, and their tasks are lost. With [patience], their tasks are asked to end
    instead ({!Interruption.fork}, [obedient]), and [work] may return what it has: from then on
    {!Interruption.heard} is true there, and a little later {!Interruption.Interrupted} is raised in it. [each] is
    called for these results too, up to the first task of which nothing is heard within [patience] seconds. *)
