(** The option [--seconds] of commands whose work has no partial result. *)

open Scc_verdicts

val seconds : float option Cmdliner.Term.t
(** The option [--seconds]. *)

val within :
  Console.t ->
  seconds:float option ->
  (unit -> ('a, 'e) result) -> ('a -> (Exit_code.t, 'e) result) -> (Exit_code.t, 'e) result
(** [within console ~seconds work report] reports what the work gives. The work is ended by an interruption, by the
    seconds, or when memory is short; then the exit code is 4, and nothing is written. *)
