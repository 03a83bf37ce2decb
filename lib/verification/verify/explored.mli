(** The state space of a model, as far as it was explored: a graph for comparison and export. *)

open Scc_calculus
open Scc_semantics
open Scc_property

type edge = {
  label : Transition.label;
  chance : Scc_exact.Rat.t option;  (** its probability, if chance decides (rules Draw, Lot and Ties) *)
  target : int;
}

type t = {
  semantics : Semantics.t;
  size : int;  (** states are numbered from 0, the initial one, in the order in which they were found *)
  state : int -> State.t;
  edges : int -> edge array;
  (** in the order of {!Scc_semantics.Network.successors}; empty while the state is not expanded *)
  expanded : int -> bool;  (** true if all transitions of the state are known *)
  rests : int -> bool;  (** the state is quiescent: nothing happens any more, and time passes for ever *)
  split_step : Scc_exact.Rat.t option;  (** the step of the grid, if a weak split is enabled in some state *)
  stopped_by : Verdict.truncation list;  (** the bounds that left states unexpanded *)
  faults : Scc_base.Diag.t list;  (** the reasons why transitions of states could not be computed, each text
                                      once *)
  dead_ends : Scc_base.Diag.t list;  (** the reasons why runs end in states without transitions, as warnings
                                         (rule Run) *)
}

(** Functions that are called while states are explored. *)
type visitor = {
  found : State.t -> unit;  (** each once *)
  expanded : State.t -> unit;  (** its transitions are known; each once *)
}

val explore : ?time_seen:Time_seen.t -> ?visitor:visitor -> Setup.t -> Semantics.t -> initial:State.t -> t
(** The state space, breadth-first, within the bounds of the options. States are distinguished by absolute time
    as far as [time_seen] says. By default that is all of it, if the model keeps it. *)

val model : t -> Model.t
(** The model of the semantics. *)

val complete : t -> bool
(** [complete t] is true if every state is expanded. *)

val unexpanded : t -> int
(** The number of states whose transitions are not known. *)

val transitions : t -> int
(** The number of known transitions. *)
