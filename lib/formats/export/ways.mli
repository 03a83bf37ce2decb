(** Runs of networks that go from event to event ({!Scc_engine.Event_run.can_run}), told by what changes: from one
    change of a process to the next it goes in a straight line. What is kept grows with what happens, and not with
    how many bodies look on; behaviours and clocks are not followed. *)

open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_exchange

type t

(** Where the process of a leaf went, from a time on. *)
type way = { since : Rat.t; process : State.process option  (** [None]: the leaf is gone *) }

val start : Semantics.t -> State.t -> t
(** At the initial state. *)

val step : t -> Replay.event -> unit
(** To be called with each event of the run after its start. *)

val model : t -> Model.t
val initial : t -> State.t

val labels : t -> (Rat.t * Transition.label) list
(** Of the transitions in order, each with the time before it. *)

val duration : t -> Rat.t

val of_leaf : t -> int -> way list
(** In order; of several of one instant, the last counts. *)

val at : t -> Rat.t -> State.t
(** Where everybody is at a time, with their bonds and velocities: of several states of one instant the last. *)
