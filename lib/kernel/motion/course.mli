(** The course of a run that has been made: its states, what led from each to the next, and where everything was in
    between. Times count from its start. *)

open Scc_exact
open Scc_calculus
open Scc_semantics

(** A transition that was taken, with the states before and after it. *)
type leg = {
  label : Transition.label;
  start : Rat.t;  (** the time before it; that after it is later by its duration *)
  before : State.t;
  after : State.t;
}

type t

val make : Semantics.t -> initial:State.t -> (Transition.label * State.t) list -> rest:Rat.t -> t
(** From the transitions in order, each with the state after it. After the last one a time [rest] >= 0 passes
    without an event, which the run need not have been followed through. *)

val semantics : t -> Semantics.t
val initial : t -> State.t
val legs : t -> leg array

val last : t -> State.t
(** After the legs. *)

val rest : t -> Rat.t

val duration : t -> Rat.t
(** Of the legs and the rest. *)

val at : t -> Rat.t -> State.t
(** The state at a time from 0 to {!duration}: of several states of one instant the last. *)

val paths : t -> State.t -> Path.t array
(** How the processes of a state go on while time passes: from the state before a leg, until it is over. *)
