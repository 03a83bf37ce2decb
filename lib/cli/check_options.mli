(** How commands that explore are told their bounds, and explore. *)

open Scc_verify
open Scc_session

val budget : Budget.t Cmdliner.Term.t
val defaults : Budget.defaults

val options :
  ?now:(unit -> float) ->
  Budget.t ->
  interrupted:(unit -> bool) ->
  progress:(Scc_explore.Limits.progress -> unit) ->
  Check.options

val starting : Console.t -> Budget.t -> interrupted:(unit -> bool) -> Check.options
(** For an exploration that begins now: its seconds are counted from here, and its progress is shown. *)
