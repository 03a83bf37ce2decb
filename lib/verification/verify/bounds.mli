(** Bounds on an exploration, and the consequences of meeting one. *)

open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_graph_search

(** A bound, and its origin. *)
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
  shared : bool;  (** the seconds are shared with other checks *)
  drawing : int option;
  (** The draws of so many bodies at one instant exceed the bound of states, for which the exploration ends before
      it ({!Draws_ahead}). *)
}

val default : t
(** No bounds except 10 000 transitions in an instant and 100 000 bits for a number, both by default. *)

val value : 'a bound -> 'a option
(** [value b] is the bound; [None] if there is none. *)

val limits : t -> horizon:Rat.t option -> Limits.t
(** [limits b ~horizon] are the limits of an exploration, where [horizon] is the time up to which the
    properties look. *)

(** The reason why a state was not expanded. *)
type cause =
  | Bound of Verdict.truncation
  | Fault of Scc_base.Diag.t
  | Early  (** everything was decided *)

val dead_end : Scc_base.Diag.t -> Scc_base.Diag.t
(** The warning that runs end in a state, from the error for which the model is given up there. *)

val long_number : Model.t -> State.t -> depth:int -> Scc_base.Diag.t
(** SC0705 for a state, at this number of transitions from the start: its longest number, and a remedy. *)

val dead_ends : Scc_state_space.Network_lts.context -> Scc_base.Diag.t list
(** A warning for each reason for which runs end in the explored states (rule Persistent). *)

val stopped : t -> Limits.stop -> Verdict.truncation
(** The truncation for a stop of the exploration. *)

val cause : t -> Model.t -> horizon:Rat.t option -> Transition.fault Explore.reason -> cause
(** [cause b model ~horizon reason] is the cause for which a state was not expanded. The bound of time is that
    of the properties if theirs is the lesser. *)
