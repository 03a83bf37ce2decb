(** The causes in a run: the events on which each event, and a fact about the end of the run, depend.

    An event depends on the earlier events that last changed its participants: the motion of processes, their
    structure, the behaviour of leaves, the start of a split clock. That is complete: the rules use nothing
    else of a process. A law of motion uses its own body alone, so a steer is no event. The rules also depend
    on the absence of other bodies, which no list of events can show; {!Omission} tests it. *)

open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_motion
open Scc_property

(** A completed run, until the instant of the fact. *)
type run = {
  declared : State.t;  (** before the initial steer, see {!Scc_semantics.Network.initial} *)
  course : Course.t;
  over : int list option;
  (** if the fact includes that the run ends in a dead end: the processes in persistent contact, by their first
      leaves *)
}

(** The aspect of a leaf on which a later event depends. *)
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
(** The events of a run with their reasons. *)

val run : t -> run
(** The run of these events. *)

val model : t -> Model.t
(** The model of the run. *)

val events : t -> event array
(** All events, in order. A passing of time is an event only if a delay expires at its end. *)

val duration : t -> Rat.t
(** The model time of the instant of the fact. *)

(** The dependencies of a fact about the end of the run. *)
type basis = {
  reasons : reason list;
  leaves : int list;  (** the leaves that the fact mentions, or whose contributions it counts *)
}

val of_formula : t -> Property.temporal -> basis
(** The dependencies of the atoms of a formula at the end of the run. *)

val of_last_event : t -> basis
(** The dependencies of the last event; none if there is no event. *)

val of_dead_end : t -> basis
(** The dependencies of the end of the run (rule DeadEnd); none if the fact does not include a dead end. *)

val union : basis list -> basis
(** All dependencies together, sorted, each once. *)

val closure : t -> int list -> bool array
(** [closure t events] is true for the events given, and for all events on which these depend, directly or
    indirectly. The array is indexed by event. *)
