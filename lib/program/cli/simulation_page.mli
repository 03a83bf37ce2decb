(** The page of [scc simulate --view]. *)

open Scc_base
open Scc_loading
open Scc_simulate

(** What the page takes of the runs of a simulation. *)
type t

val create : Simulation.plan -> t
(** Nothing, before the first run. *)

val add : t -> Simulation.run -> unit
(** Adds a run. Runs are added in order. *)

val write :
  t ->
  Console.t ->
  Loaded.t ->
  path:string ->
  name:string ->
  report:Report.t ->
  asked:int ->
  first:int ->
  summary:Report.summary ->
  interrupted:(unit -> bool) ->
  (bool, Diag.t list) result
(** [write t console model ~path ~name ~report ~asked ~first ~summary ~interrupted] writes the page of the runs
    from number [first] on to [path]. [asked] runs were to be made, and [summary] has their values. [name] is that
    of the file of the model. If [interrupted ()] is or becomes true, the page gets the runs that are made in a few
    seconds, at least one. The result is true if it has all runs that it would have otherwise. *)

val too_large : times:int -> observables:int -> string option
(** Why there is no page of so many times and observables, if there is none. *)
