(** Runs of networks with so many bodies that states are not examined one by one. Each state is given by its
    changes, so the cost is about that of the events. *)

open Scc_exact
open Scc_calculus
open Scc_runs

(** A run so far. *)
type t

val is_for : Model.t -> bool
(** [is_for m] is true for models of more than 100 leaves that run from event to event
    ({!Scc_engine.Run.eventwise}). *)

val start : States.world -> state_after:(int -> State.t) -> State.t -> t
(** A run at the initial state. [state_after n] computes the state after [n] steps anew; it is called if that
    state is needed as a whole. *)

val step : t -> Replay.event -> unit
(** Adds an event. It must be called with each event of the run. Where the run does not tell its
    changes ({!Scc_engine.Run.changes}), whole states are compared. *)

val run : ?until:Rat.t -> t -> name:string -> finish:string -> ending:string list -> Runs.t
(** The run as a run of the document, with its name, its kind of end and lines about its end. Where nothing happens
    any more, it is shown for {!Runs.a_while}, or up to the time [until]. *)
