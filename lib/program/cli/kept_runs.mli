(** Tasks of which each depends on its number alone (runs, points), worked on by several processes
    ({!Scc_workers.Pool}), and kept in a store, if there is one. *)

open Scc_base
open Scc_store

type 'a t
(** What comes of a task, in the order of tasks. It must be something that {!Marshal} takes. *)

val start : Store.t option -> string -> 'a t
(** Under this name ({!Store.log}). What the store has of it must be of this type, which its identity ensures: it
    is of one build, command and set of options. *)

val run :
  'a t ->
  jobs:int ->
  first:int ->
  count:int ->
  work:(int -> 'a) ->
  interrupted:(unit -> bool) ->
  each:(int -> 'a -> unit) ->
  (unit, Scc_workers.Pool.stop) result
(** As {!Scc_workers.Pool.run}; what was kept is not worked on again. Called again, it goes on: [first] is where it
    ended. *)

val loss : fault:bool -> Scc_session.Exit_code.t
(** Of a run that is lost ({!Scc_workers.Pool.stop}). *)

val close : 'a t -> Diag.t list
(** What went wrong with the store. *)
