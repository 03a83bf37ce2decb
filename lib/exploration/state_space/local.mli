(** The transitions of single processes and of pairs of processes, in a network in translation. Each is computed
    once, and cached as long as there is room. *)

open Scc_exact
open Scc_geometry
open Scc_broad_phase
open Scc_semantics
open Scc_property
open Scc_graph_search

(** A transition of some processes, as a change of the whole tuple. *)
type move = {
  step : Lts.step;
  leaf : int;  (** the first leaf of one of the processes *)
  takes_out : bool;  (** the processes leave the network, and none comes instead (rule Absorb) *)
  deed : Ties.deed option;  (** what it does, if it is urgent in a model that draws ties (rule Ties) *)
}

(** What depends on the form of a process alone. *)
type nature = {
  splits : bool;  (** it has an urgent transition or a weak split at a split instant *)
  wait : Rat.t option;  (** the time until an eps expires, or until the next split instant *)
}

(** A process with its transitions by itself. *)
type alone = private {
  body : Catalogue.body;
  nature : nature;
  urgent : move list;
  weak : move list;
  rests : bool;  (** its velocity is zero *)
  boxes : Float_box.t array;  (** the boxes of its parts, in the world *)
  line : Moving_boxes.t Scc_base.Later.t;
  (** a box about all its parts, and then the boxes of the parts, on their course for ever *)
  mutable passed : Rat.t;  (** the last argument of {!val-after} *)
  mutable after : int;  (** its result *)
}

type t

val create :
  events:Property.event list -> time_seen:Time_seen.t -> memory:int -> Semantics.t -> t
(** [create ~events ~time_seen ~memory c] has empty caches and a new catalogue. [events] mark states
    ({!Network_lts.make}), and [time_seen] is as in {!Catalogue.create}. [memory], a power of two, bounds the
    caches. *)

val semantics : t -> Semantics.t
(** The semantics, with its own caches. *)

val afresh : t -> Semantics.t
(** The semantics without its cache of processes ([Semantics.without_memo]), as this module caches the same
    answers. *)

val catalogue : t -> Catalogue.t
(** The numbers of all components. *)

val mark : t -> source:Scc_calculus.State.t -> Transition.label -> int
(** The number of the set of those {!events} that a transition with this label from [source] matches; 0 without
    events. *)

val events : t -> Property.event list
(** The events that mark states, as given to {!create}. *)

val has_events : t -> bool
(** [has_events t] is true if some events mark states. *)

val events_of : t -> int -> int list
(** The events of the set with this number, as increasing indices into {!events}. *)

val mark_of : t -> int list -> int
(** The number of a set of events, given as increasing indices into {!events}. *)

val place : t -> Property.event -> int option
(** The index of an event in {!events}; [None] if it is not among them. *)

val move : t -> Transition.outcome -> move
(** An outcome of some processes as a change of the whole tuple, including the mark. *)

val nobody : t -> alone
(** The value that stands for no process: its number is {!Catalogue.nobody}. *)

val tied : t -> move Scc_semantics.Network.discrete -> move Scc_semantics.Network.discrete
(** The moves of a state with the chances of urgent ones in their labels, if the model draws ties (rule Ties). *)

val alone : t -> int -> alone
(** The process with this number, which must not be {!Catalogue.nobody}. *)

val after : t -> Rat.t -> alone -> int
(** [after t d a] is the number of the process [a] after a time [d] in which nothing else happens to it. *)

val collisions : t -> alone -> alone -> move list
(** The outcomes of a collision of two processes in relative motion; empty if they do not collide now. *)

val share : t -> Scc_graph_search.Common.t -> Catalogue.texts -> bool
(** [share t table texts] is {!Catalogue.share} of the catalogue. Marks have the kind 4. *)

val numbers_so_far : t -> int
(** [numbers_so_far t] is more than any number that has been given, marks included. *)
