(** From a state, as its bytes, to the states that follow it in a search ({!Scc_ctl.On_the_fly}). *)

open Scc_base
open Scc_exact
open Scc_ctl
open Scc_semantics

(** A filter with its caches. *)
type t

val make : Question.t -> t
(** A filter for a question, with empty caches. *)

val question : t -> Question.t
(** The question of the filter. *)

val keys : t -> Keys.t
(** The bytes and fingerprints of its states. *)

val context : t -> Scc_state_space.Network_lts.context
(** The transition system of the exploration. *)

val predicates : t -> On_the_fly.predicate array
(** The predicates of the goals. *)

val events : t -> Scc_property.Property.event list
(** The events by which states differ if they have just happened. *)

(** {1 Labels}

    Labels are numbered from 0 in the order in which they are first met. Numbers stay valid as long as the filter
    exists. *)

val labels : t -> int
(** The number of labels met so far. *)

type label = Transition.label * Scc_exact.Rat.t option
(** A label, and its probability if chance decides ({!Catalogue.chance}). *)

val label : t -> int -> label
(** The label with a number. *)

(** {1 States} *)

(** A state that is reached. *)
type reached = {
  tuple : int array;
  fingerprint : Keys.fingerprint;
  goals : Truth.t array;  (** the truth value of each goal, at its instant *)
  too_long : bool;  (** it has a number that is longer than the bound of bits, and is not to be expanded *)
}

(** A moment at which a goal holds. *)
type met = {
  choice : int option;
  (** in the transition of this place among all, or, with [None], while time passes for ever *)
  moment : Timeline.moment;
  sample : Algebraic.t;  (** an offset at which it holds *)
}

(** The truth of a goal after a state, before the next one. *)
type ahead = {
  met : met option;  (** it holds at some moment *)
  doubt : string option;  (** it could not be decided at some moment *)
  doubtful : Timeline.moment option;  (** the first such moment; [Some] iff [doubt] is *)
}

(** The continuation of a state. *)
type 'moves following =
  | Moves of 'moves list  (** in order; not empty *)
  | Rests  (** there is none, and time passes for ever *)
  | Ends of Diag.t  (** a dead end: the model is given up *)
  | Stops  (** there is none, and time does not pass *)
  | Fault of Diag.t  (** they cannot be computed *)

type bare = Scc_graph_search.Lts.step following
(** Steps of {!context}, whose targets are not computed. *)

type follows = (int * reached) following
(** Labels and targets. *)

(** A state with what follows it. *)
type expanded = {
  state : reached;
  follows : follows;
  ahead : ahead option array;  (** by goal; [None] for those that change only at events *)
}

val initial : t -> reached
(** The initial state of the exploration. *)

val read : t -> string -> from:int -> stop:int -> (int array, Diag.t) result
(** The state of these bytes. Bytes of no state are SC0920. *)

val expand : t -> int array -> (expanded, Diag.t) result
(** The state with its targets and the goals ahead. A state to which the rules do not apply cannot be reached
    and is SC0920. *)

val look : t -> int array -> (bare * ahead option array, Diag.t) result
(** The steps of a state and the goals ahead, without targets. Errors are as in {!expand}. *)

val label_number : t -> int -> int
(** [label_number f n] is the number of the label that has the number [n] in {!context}. *)

val reach : t -> int array -> Keys.fingerprint -> reached
(** The state with its goals, whose fingerprint is known. *)

val renew : ?most:int -> t -> t
(** The filter itself, or, if its context has more than [most] processes (default: 4 000 000), one with empty
    caches. Tuples of the old filter mean nothing to the new one. Labels keep their numbers. *)
