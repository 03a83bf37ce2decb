(** The predicates that hold in the states of an explored graph and, on request, at the instants between two
    states at which one of them changes. *)

open Scc_exact
open Scc_verify

(** The kind of a state, as far as its transitions show it. *)
type status =
  | Moves  (** it has transitions, and all of them are known *)
  | Rests  (** nothing will ever happen again, and time passes for ever *)
  | Stuck  (** nothing can happen, not even the passing of time *)
  | Unexplored  (** its transitions are not known *)

(** A stretch of time inside a passing of time, on which nothing changes. *)
type stretch = {
  attained : bool;  (** it contains its first instant, and does not only begin right after it *)
  holds : bool array;  (** by predicate *)
  lasts : Rat.t option;  (** until the next one, or until the state that time leads to; [None]: for ever *)
  target : int;  (** the number of what comes next: a stretch, a state, or itself when it lasts for ever *)
  source : int;  (** the state in which time began to pass *)
}

(** The predicates that hold in a graph. *)
type t

val make : ?instants:bool -> Explored.t -> State_predicates.t array -> t
(** Evaluates every predicate in every state and along every passing of time. With [instants] (default: false),
    a passing of time during which a predicate changes becomes a chain of stretches, numbered after the
    states. *)

val space : t -> Explored.t
(** The explored graph. *)

val predicates : t -> State_predicates.t array
(** The predicates, in the order of their numbers. *)

val size : t -> int
(** The number of states and stretches. *)

val status : t -> int -> status
(** The status of a state. *)

val holds : t -> int -> int -> bool
(** [holds l i k] is true if the predicate [k] holds in the state or stretch [i]. *)

val stretch : t -> int -> stretch option
(** The stretch with a number from [Explored.size] on, and [None] for a state. *)

val detour : t -> int -> (Rat.t * int) option
(** The time that passes in a state before its first stretch, and the number of that stretch. The detour
    replaces the state's passing of time, or its rest. *)

val changes : t -> int -> int
(** The number of passings of time (or rests) in which predicate [k] changes, between the start (included) and
    the end. *)

val undecided : t -> int -> (int * string) option
(** A state in which, or after which, predicate [k] has no truth value, and why. Its label is missing there. *)

val inexact : t -> int
(** The number of irrational instants between states. The times next to them are within 10^-12. *)

val count : t -> status -> int
(** The number of states with a status. *)
