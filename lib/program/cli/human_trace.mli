(** Runs in words, event by event. *)

open Scc_calculus
open Scc_runs

val teller : Model.t -> full:bool -> Trace.states -> (string -> unit) -> Replay.event -> unit
(** [teller model ~full states write] is a function that must be called with each event of a run. Passings of
    equal time in a row are one line, with the state after the last of them, and unchanged processes are only
    named. If [full], each transition is a line with the whole state, and numbers have all their digits. *)
