(** From a state, as its bytes, to what follows it, as a search sees it ({!Scc_ctl.On_the_fly}). *)

open Scc_base
open Scc_exact
open Scc_ctl
open Scc_semantics

type t

val make : Question.t -> t
val question : t -> Question.t
val keys : t -> Keys.t
val context : t -> Scc_state_space.Network_lts.context
val predicates : t -> On_the_fly.predicate array
val events : t -> Scc_property.Property.event list
(** That states are told apart by, when they have just happened. *)

(** {1 Labels}

    Numbered from 0 as they are first met, for as long as the filter is there. *)

val labels : t -> int
(** How many have been met. *)

val label : t -> int -> Transition.label

(** {1 States} *)

(** A state that is reached. *)
type reached = {
  tuple : int array;
  fingerprint : Keys.fingerprint;
  goals : Truth.t array;  (** what holds in it, at its instant *)
  too_long : bool;  (** it has a number that is longer than the bound of bits, and is not to be expanded *)
}

(** A moment at which a goal holds. *)
type met = {
  choice : int option;
  (** in the transition of this place among all, or, with [None], while time passes for ever *)
  moment : Timeline.moment;
  sample : Algebraic.t;  (** an offset at which it holds *)
}

(** What is known of a goal after a state, before the next one. *)
type ahead = {
  met : met option;  (** it holds at some moment *)
  doubt : string option;  (** it could not be decided at some moment *)
}

type 'moves following =
  | Moves of 'moves list  (** in order; not empty *)
  | Rests  (** there is none, and time passes for ever *)
  | Ends of Diag.t  (** a dead end: the model is given up *)
  | Stops  (** there is none, and time does not pass *)
  | Fault of Diag.t  (** they cannot be computed *)

type bare = Scc_graph_search.Lts.step following
(** Steps of {!context}: nothing has been worked out of where they lead. *)

type follows = (int * reached) following
(** Labels and targets. *)

type expanded = {
  state : reached;
  follows : follows;
  ahead : ahead option array;  (** by goal; [None] of those that only change at events *)
}

val initial : t -> reached
val read : t -> string -> from:int -> stop:int -> (int array, Diag.t) result
(** SC0920 of what is no state. *)

val expand : t -> int array -> (expanded, Diag.t) result
(** SC0920 of a state to which the rules do not apply, as it is none that can be reached. *)

val look : t -> int array -> (bare * ahead option array, Diag.t) result
(** The same, and not more than that. *)

val label_number : t -> int -> int
(** Of a label of {!context}. *)

val reached : t -> int array -> reached

val reach : t -> int array -> Keys.fingerprint -> reached
(** The same, of a state whose fingerprint is known. *)

val renew : ?most:int -> t -> t
(** With an empty memory, if what there is has become large (more processes of the network than [most]): tuples of
    the one before mean nothing to it then. Labels keep their numbers. *)
