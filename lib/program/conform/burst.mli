(** Events that were met ahead of what was recorded before them: near-simultaneous ones of separate bodies, which
    may have been recorded in either order. What is recorded of their bodies meanwhile is from before them or from
    after. *)

open Scc_exact
open Scc_calculus

type event = private {
  item : int;  (** of the trace *)
  leaves : int list;  (** of the processes that took part *)
  before : State.t;  (** of these processes alone, just before it *)
  time : Rat.t;  (** when it happened in the run *)
  order : int;  (** in which events happened *)
}

val met : State.t -> firsts:int list -> time:Rat.t -> item:int -> order:int -> event
(** An event of this state, of the processes of these leaves. *)

val equal : event -> event -> bool
(** But for the order. *)

val differences :
  Against.t ->
  now:State.t ->
  time:Rat.t ->
  event list ->
  Recorded.body list ->
  Recorded.step option ->
  Against.difference list * Against.deviation
(** Of what was recorded at that time, when these have been met ahead of it, from the state [now] of the run. A
    body of theirs may be as it was just before one of its events, there or where it would be at that time without
    the event; an event has happened to all of its bodies that are told of, or to none. *)
