(** Options of commands that make many runs. *)

open Cmdliner

val seed : int64 Term.t
val jobs : int Term.t
val seconds : float option Term.t
