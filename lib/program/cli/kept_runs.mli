(** Tasks that depend on their number alone (runs, points). Several processes work on them
    ({!Scc_workers.Pool}), and a store keeps their results, if there is one. *)

open Scc_base

type 'a t
(** Tasks with results of type ['a], in order. {!Marshal} must accept the results. *)

val openly :
  ?elsewhere:Runs_elsewhere.t ->
  Console.t -> folder:string option -> identity:(string * string) list -> string -> ('a t, Diag.t list) result
(** [openly ~elsewhere console ~folder ~identity name] has the tasks under this name in the store of the folder
    ({!Kept.openly}), or keeps nothing without a folder. The results in the store must have this type. Its identity
    ensures that: it includes the build, the command and the options. With [elsewhere] other processes do what is
    not in the store. *)

val run :
  ?patience:float ->
  ?whole:('a -> bool) ->
  ?turn:int ->
  'a t ->
  jobs:int ->
  first:int ->
  count:int ->
  work:(int -> 'a) ->
  interrupted:(unit -> bool) ->
  each:(int -> 'a -> unit) ->
  (unit, Scc_workers.Pool.stop) result
(** Does the tasks, as {!Scc_workers.Pool.run}, except those with results in the store. A further call continues:
    [first] is where the last call ended. With [patience], tasks that are under way at an interruption may return
    what they have. [turn] (default: 0) is for those who work elsewhere. Only results that are [whole] (default:
    all) are stored. *)

val lost : what:string -> task:int -> how:string -> string
(** The loss of a task as a clause: ["run 7 is lost: a process was killed"]. [what] names a task. *)

val loss : fault:bool -> Scc_verdicts.Exit_code.t
(** The exit code of a run that is lost ({!Scc_workers.Pool.stop}). *)

val stopped :
  ?why:string ->
  ?partly:int ->
  Console.t -> what:string -> written:int -> count:int -> Scc_workers.Pool.stop -> Scc_verdicts.Exit_code.t
(** Notes why the tasks ended early ([why] for [Interrupted], by default that word), and how many of them are
    [written], and how many more [partly] (default: 0). The result is the exit code for it. *)

val close : 'a t -> Diag.t list
(** Closes the store, and returns its error if writing to it failed. *)

val finish : Console.t -> 'a t -> Scc_verdicts.Exit_code.t -> Scc_verdicts.Exit_code.t
(** Closes the store and reports its error, if it has one. The result is the worse of the exit code and that of the
    error. *)
