(** Why a recorded trace is no run of the model: the first item that no run has, and the events that were
    allowed instead. *)

open Scc_exact
open Scc_semantics

(** The kind of divergence. *)
type kind =
  | Wrong_time  (** the event is allowed, at another time; or there is no such time *)
  | Wrong_features
  | Wrong_channel
  | Wrong_kind  (** something else happens to these bodies *)
  | Wrong_partner  (** it happens, to other bodies *)
  | Wrong_order  (** what was recorded next has to come first *)
  | Missing_event  (** something has to happen before, and was not recorded *)
  | Extra_event  (** nothing like it is allowed *)
  | Wrong_position
  | Wrong_velocity
  | Wrong_spin
  | Wrong_orientation
  | Wrong_bonds  (** the bodies of a process, or its bonds *)
  | Wrong_behaviour
  | Wrong_clock
  | Wrong_presence
  | Wrong_step
  | Wrong_ending  (** it claims that nothing can happen *)
  | Time_back  (** its times decrease *)

val kind_name : kind -> string
(** The name of a kind, such as ["wrong-time"]. *)

val all : kind list
(** All kinds. *)

(** An event that was allowed. *)
type allowed = { label : Transition.label; rules : Rule.t list; time : Rat.t }

(** A divergence. *)
type t = {
  kind : kind;
  item : Recorded.item;  (** the first that does not fit *)
  rules : string list;  (** entries of the rule book that are violated, the most specific one first *)
  why : string;  (** a sentence *)
  closest : allowed option;
  off : Rat.t option;  (** the time of the item less that of [closest] *)
  differences : Against.difference list;  (** of a state *)
  allowed : allowed list;  (** those nearest in time, in order of it, at most 12 *)
  after : allowed option;  (** the latest transition before it *)
}

val find :
  Against.t -> Recorded.t -> observed:(Scc_semantics.Transition.label -> bool) -> Trace_search.dead_end -> t
(** Finds the first divergence of a trace, from a dead end of its search. *)
