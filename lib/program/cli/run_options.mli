(** Options of commands that make many runs, or look at many points. *)

open Cmdliner

val seed : int64 Term.t
(** The option [--seed]: an integer of 64 bits (default: 0). *)

val jobs : int Term.t
(** The option [--jobs]: a number of processes from 1 to 1024 (default: 1). *)

val seconds : float option Term.t
(** The option [--seconds]: the greatest time for runs, in seconds of the clock. *)

