(** Events that were met ahead of items that were recorded before them. Near-simultaneous events of separate
    bodies may be recorded in either order. Meanwhile, records of their bodies are from before these events or
    from after them. *)

open Scc_exact
open Scc_calculus

(** An event that was met ahead. *)
type event = private {
  item : int;  (** its index in the trace *)
  leaves : int list;  (** of the processes that took part *)
  before : State.t;  (** of these processes alone, just before it *)
  time : Rat.t;  (** model time at which it happened in the run *)
  order : int;  (** its rank in the order in which events happened *)
}

val met : State.t -> firsts:int list -> time:Rat.t -> item:int -> order:int -> event
(** [met s ~firsts ~time ~item ~order] is an event of the state [s] and of the processes of the leaves
    [firsts]. *)

val equal : event -> event -> bool
(** Equality up to [order]. *)

val differences :
  Against.t ->
  now:State.t ->
  time:Rat.t ->
  event list ->
  Recorded.body list ->
  Recorded.step option ->
  Against.difference list * Against.deviation
(** The differences between the state [now] of the run and what was recorded at [time], when these events have
    been met ahead.

    A body of one of the events may be as it was just before it, at its place then or at the place at [time]
    without the event. Each event has happened to all of its recorded bodies, or to none. *)
