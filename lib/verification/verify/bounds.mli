(** Bounds on an exploration, and what it means that one was met. *)

open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_graph_search

(** A bound, and whose it is. *)
type 'a bound = Unbounded | Default of 'a | Given of 'a

type t = {
  depth : int bound;
  time : Rat.t bound;
  states : int bound;
  seconds : float bound;
  memory : int bound;  (** words of the heap *)
  room : int option;
  (** words: the limit that the system sets this process, where it is met before [memory] is *)
  instant : int bound;  (** the guard against runs that go on for ever within one instant *)
  bits : int bound;  (** of a number in a state *)
}

val default : t
(** None but an instant of 10 000 transitions, and numbers of 100 000 bits (both by default). *)

val limits : t -> horizon:Rat.t option -> Limits.t
(** [horizon] is the time up to which the properties look. *)

(** Why a state was not expanded. *)
type cause =
  | Bound of Verdict.truncation
  | Fault of Scc_base.Diag.t
  | Early  (** everything was decided *)

val dead_end : Scc_base.Diag.t -> Scc_base.Diag.t
(** Of the error that a model is given up, the warning that runs end there. *)

val long_number : Model.t -> State.t -> depth:int -> Scc_base.Diag.t
(** SC0705 of a state that so many transitions led to: which of its numbers is the longest, and what helps. *)

val dead_ends : Scc_state_space.Network_lts.context -> Scc_base.Diag.t list
(** A warning for each reason for which runs end in what was explored (rule Persistent). *)

val stopped : t -> Limits.stop -> Verdict.truncation
(** What ended the work. *)

val cause : t -> Model.t -> horizon:Rat.t option -> Transition.fault Explore.reason -> cause
