(** What single processes do by themselves in a network in translation, and what two do together: each is worked
    out once and remembered for as long as there is room. *)

open Scc_exact
open Scc_geometry
open Scc_broad_phase
open Scc_semantics
open Scc_property
open Scc_graph_search

(** What a transition of some processes changes of the whole. *)
type move = {
  step : Lts.step;
  leaf : int;  (** of one of them *)
  takes_out : bool;  (** one of them is in the network no more (rule Absorb) *)
}

(** What a form decides, wherever the process is. *)
type nature = { splits : bool; wait : Rat.t option  (** until an eps expires or the next split instant *) }

(** What a process does by itself. *)
type alone = private {
  body : Catalogue.body;
  nature : nature;
  urgent : move list;
  weak : move list;
  rests : bool;
  boxes : Float_box.t array;  (** of its parts *)
  line : Moving_boxes.t Scc_base.Later.t;  (** a box about all of them, and those, as they move on for ever *)
  mutable passed : Rat.t;  (** the last time that passed for it, and what became of it *)
  mutable after : int;
}

type t

val create :
  events:Property.event list -> time_seen:Time_seen.t -> memory:int -> Semantics.t -> t
(** Where events mark states ({!Network_lts.make}). [memory], a power of two, bounds what is remembered. *)

val semantics : t -> Semantics.t

val afresh : t -> Semantics.t
(** {!Semantics.without_memo}: what is told here is remembered here. *)

val catalogue : t -> Catalogue.t

val mark : t -> source:Scc_calculus.State.t -> Transition.label -> int
(** The number of the set of the events that a transition from a state is of. *)

val events : t -> Property.event list
(** Those of {!create}. *)

val has_events : t -> bool
(** Whether some mark states. *)

val events_of : t -> int -> int list
(** The places of the events of the set of this number. *)

val mark_of : t -> int list -> int
(** The number of a set of events, by their places, increasing. *)

val place : t -> Property.event -> int option
(** Of an event among {!events}. *)

val move : t -> Transition.outcome -> move

val nobody : t -> alone
(** No process; its number is {!Catalogue.nobody}. *)

val alone : t -> int -> alone
(** The process of this number. *)

val after : t -> Rat.t -> alone -> int
(** What it is when a time has passed, in which nothing else happens to it. *)

val collisions : t -> alone -> alone -> move list
(** Of two that move relative to each other. *)
