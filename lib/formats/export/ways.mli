(** Runs of networks that go from event to event ({!Scc_engine.Event_run.can_run}), stored as changes. From one
    change of a process to the next it moves in a straight line. Memory grows with the number of changes, not
    with that of bodies at rest. Behaviours and clocks are not stored. *)

open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_runs

(** The changes of a run so far. *)
type t

(** The process of a leaf from a time on. *)
type way = { since : Rat.t; process : State.process option  (** [None]: the leaf is gone *) }

val start : Semantics.t -> State.t -> t
(** A run at the initial state. *)

val step : t -> Replay.event -> unit
(** Adds an event of the run. It must be called with each event after the start, in order. *)

val model : t -> Model.t
(** The model of the run. *)

val initial : t -> State.t
(** The initial state. *)

val labels : t -> (Rat.t * Transition.label) list
(** The labels of the transitions in order, each with the time before it. *)

val duration : t -> Rat.t
(** The model time that has passed. *)

val of_leaf : t -> int -> way list
(** The ways of a leaf in order. If several begin at one instant, the last counts. *)

val at : t -> Rat.t -> State.t
(** The places, bonds and velocities of all processes at a time. If several states have this time, it is the
    last of them. The run must be over. *)
