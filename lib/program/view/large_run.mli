(** Runs of networks so large that their states are not looked at one by one: what is told of each is what has
    changed, which costs about as much as what has happened. *)

open Scc_calculus
open Scc_exchange

type t

val is_for : Model.t -> bool
(** Of more than 100 leaves, and of those that run from event to event. *)

val start : States.world -> state_after:(int -> State.t) -> State.t -> t
(** At the initial state. [state_after] finds the state after so many steps anew, for who asks about it as a
    whole. *)

val step : t -> Replay.event -> unit
(** To be called with each event of a run from event to event ({!Scc_engine.Run.changes}; a bug for another
    one). *)

val steps : t -> int
val json : t -> name:string -> finish:string -> ending:string list -> Json.t
