(** The state space of a model, as far as it was explored: a graph for those who compare or export it. *)

open Scc_calculus
open Scc_semantics
open Scc_property

type edge = { label : Transition.label; target : int }

type t = {
  semantics : Semantics.t;
  size : int;  (** states are numbered from 0, the initial one, in the order in which they were found *)
  state : int -> State.t;
  edges : int -> edge array;
  (** in the order of {!Network.successors}; empty while the state is not expanded *)
  expanded : int -> bool;  (** whether all transitions of the state are known *)
  rests : int -> bool;  (** the state is quiescent: nothing happens any more, and time passes for ever *)
  split_step : Scc_exact.Rat.t option;  (** when a weak split is enabled in some state *)
  stopped_by : Verdict.truncation list;  (** the bounds that left states unexpanded *)
  faults : Scc_base.Diag.t list;  (** why transitions of states could not be computed, each text once *)
  dead_ends : Scc_base.Diag.t list;  (** why runs end in states without transitions, as warnings (rule Run) *)
}

(** Who is told of states while they are explored. *)
type visitor = {
  found : State.t -> unit;  (** each once *)
  expanded : State.t -> unit;  (** its transitions are known; each once *)
}

val explore : ?time_seen:Time_seen.t -> ?visitor:visitor -> Check.options -> Semantics.t -> initial:State.t -> t
(** Breadth-first, within the bounds of the options. States differ by as much of absolute time as is seen: by all
    of it by default, where the model keeps it. *)

val model : t -> Model.t

val complete : t -> bool
(** Every state is expanded. *)

val unexpanded : t -> int
(** How many states have transitions that are not known. *)

val transitions : t -> int
(** How many are known. *)
