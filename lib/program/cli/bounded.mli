(** The options [--seconds] and [--memory] of commands whose work has no partial result. *)

open Scc_verdicts

type t = {
  seconds : float option;
  memory : int;  (** words *)
}
(** What the work may take. *)

val term : t Cmdliner.Term.t
(** The two options. *)

val exit : string
(** When the exit code is {!Exit_code.Stopped}, for manuals. *)

val within :
  Console.t ->
  t ->
  (unit -> ('a, 'e) result) -> ('a -> (Exit_code.t, 'e) result) -> (Exit_code.t, 'e) result
(** [within console bounds work report] reports what the work gives. The work is ended by an interruption, by the
    seconds, or when memory is short; then the exit code is 4, and nothing is written. *)
