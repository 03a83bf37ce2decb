(** The causal story of a run: which of its events each event, and a fact about its end, depend on.

    An event depends on the earlier events that last changed what takes part in it: how the processes move,
    of what they consist, what their leaves do, since when a split clock runs. That is enough: the rules look
    at nothing else of a process (a law of motion looks at its own body alone, so that a steer is no event).
    What they look at beside is the absence of others, which no list of events can show; {!Omission} tries it
    out. *)

open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_motion
open Scc_property

(** A run that has been made, until the instant of the fact. *)
type run = {
  declared : State.t;  (** before the initial steer, see {!Network.initial} *)
  course : Course.t;
  over : int list option;
  (** of a run whose fact is, too, that it ends in a dead end: the processes in persistent contact, by their first
      leaves *)
}

(** What of a leaf a later event depends on. *)
type aspect =
  | Motion  (** velocity and line of flight of its process *)
  | Structure  (** which leaves and bonds its process has *)
  | Behaviour
  | Clock  (** since when the split clock of its process runs (reading I-9) *)
  | Itself  (** the event is what the fact is about *)

(** The event [cause] (an index of {!events}) was the last to change this. *)
type reason = { cause : int; aspect : aspect; leaf : int }

type happening =
  | Discrete of Transition.label
  | Expiry of int  (** an eps of the leaf has expired at the end of a passing of time *)

type event = {
  step : int;  (** the index of its transition *)
  time : Rat.t;  (** model time *)
  happening : happening;
  leaves : int list;  (** of the processes that take part, in order *)
  reasons : reason list;  (** without repetition, earlier causes first *)
}

type t

val tell : run -> t
val run : t -> run
val model : t -> Model.t

val events : t -> event array
(** In order. Times that merely pass are no events. *)

val duration : t -> Rat.t
(** Model time of the instant of the fact. *)

(** What a fact about the end of the run depends on. *)
type basis = {
  reasons : reason list;
  leaves : int list;  (** that it speaks of, or whose contribution it counts *)
}

val of_formula : t -> Property.temporal -> basis
(** The truth of the atoms of a formula at the end of the run. *)

val of_last_event : t -> basis
(** That the last event happened; nothing when there is none. *)

val of_dead_end : t -> basis
(** That the run is over (rule DeadEnd); nothing when that is no part of the fact. *)

val union : basis list -> basis

val closure : t -> int list -> bool array
(** By event: whether it is one of those given, or one of the events that these depend on, transitively. *)
