(** The options of [scc check]. *)

open Scc_exact
open Scc_verify

type bounds = {
  depth : int option;
  time : Rat.t option;
  states : int option;
  seconds : float option;
  memory : int option;  (** MiB *)
}

val bounds : bounds Cmdliner.Term.t

val default_states : int
val default_memory : int
(** MiB. *)

val words_of_mib : int -> int

val options :
  ?now:(unit -> float) ->
  bounds ->
  interrupted:(unit -> bool) ->
  progress:(Scc_explore.Limits.progress -> unit) ->
  Check.options
