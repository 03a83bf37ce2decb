(** Runs in words, event by event. *)

open Scc_calculus
open Scc_exchange

val teller : Model.t -> full:bool -> Trace.states -> (string -> unit) -> Replay.event -> unit
(** [teller model ~full states write] is to be called with each event of a run. Passings of the same time are told
    together, with the state after the last of them, and processes that are as they were told last are named only;
    if [full], each transition is told by itself, with all of the state, and numbers have all their digits. *)
