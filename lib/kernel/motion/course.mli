(** The course of a run that has been made: its states, the transitions between them, and the places of all
    bodies in between. Times count from the start of the run. *)

open Scc_exact
open Scc_calculus
open Scc_semantics

(** A transition that was taken, with the states before and after it. *)
type leg = {
  label : Transition.label;
  start : Rat.t;  (** the time before it; the time after it is later by its duration *)
  before : State.t;
  after : State.t;
}

type t

val make : Semantics.t -> initial:State.t -> (Transition.label * State.t) list -> rest:Rat.t -> t
(** [make c ~initial transitions ~rest] is the course from [initial] along the transitions, each with the state
    after it. After the last one a time [rest] >= 0 passes without an event. *)

val semantics : t -> Semantics.t
(** The semantics of the run. *)

val initial : t -> State.t
(** The state at time 0, before all legs. *)

val legs : t -> leg array
(** The transitions of the course, in order. *)

val last : t -> State.t
(** The state after the last leg; the initial state if there are no legs. *)

val rest : t -> Rat.t
(** The time that passes after the last leg without an event. *)

val duration : t -> Rat.t
(** The length in time of the whole course: all legs and the rest. *)

val at : t -> Rat.t -> State.t
(** The state at a time from 0 to {!duration}. Where several states have one instant, it is the last of them. *)

val paths : t -> State.t -> Path.t array
(** The paths of the processes of a state while time passes, in the order of the processes. For the state before
    a leg they are valid until the leg is over. *)
