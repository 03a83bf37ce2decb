(** Tasks that depend on their number alone (runs, points). Several processes work on them
    ({!Scc_workers.Pool}), and a store keeps their results, if there is one. *)

open Scc_base
open Scc_store

type 'a t
(** Tasks with results of type ['a], in order. {!Marshal} must accept the results. *)

val start : Store.t option -> string -> 'a t
(** The tasks under this name in the store ({!Store.log}). The results in the store must have this type. Its
    identity ensures that: it includes the build, the command and the options. *)

val run :
  'a t ->
  jobs:int ->
  first:int ->
  count:int ->
  work:(int -> 'a) ->
  interrupted:(unit -> bool) ->
  each:(int -> 'a -> unit) ->
  (unit, Scc_workers.Pool.stop) result
(** Does the tasks, as {!Scc_workers.Pool.run}, except those with results in the store. A further call
    continues: [first] is where the last call ended. *)

val loss : fault:bool -> Scc_verdicts.Exit_code.t
(** The exit code of a run that is lost ({!Scc_workers.Pool.stop}). *)

val close : 'a t -> Diag.t list
(** Closes the store, and returns its error if writing to it failed. *)
