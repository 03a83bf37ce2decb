(** Which predicates hold where in an explored graph: in its states, and, on request, at the instants between
    two states at which one of them changes. *)

open Scc_exact
open Scc_verify

(** What a state is to those who see transitions only. *)
type status =
  | Moves  (** it has transitions, and all of them are known *)
  | Rests  (** nothing will ever happen again, and time passes for ever *)
  | Stuck  (** nothing can happen, not even the passing of time *)
  | Unexplored  (** its transitions are not known *)

(** A stretch of time inside a passing of time, on which nothing changes. *)
type stretch = {
  attained : bool;  (** it holds from its first instant on, and not only right after it *)
  holds : bool array;  (** by predicate *)
  lasts : Rat.t option;  (** until the next one, or until the state that time leads to; [None]: for ever *)
  target : int;  (** the number of what comes next: a stretch, a state, or itself when it lasts for ever *)
  source : int;  (** the state in which time began to pass *)
}

type t

val make : ?instants:bool -> Explored.t -> State_predicates.t array -> t
(** Evaluates every predicate in every state and along every passing of time. With [instants] (off by default), a
    passing of time during which a predicate changes becomes a chain of stretches, numbered after the states. *)

val space : t -> Explored.t
val predicates : t -> State_predicates.t array

val size : t -> int
(** States and stretches. *)

val status : t -> int -> status
(** Of a state. *)

val holds : t -> int -> int -> bool
(** [holds l i k]: predicate [k] holds in the state or stretch [i]. *)

val stretch : t -> int -> stretch option
(** What a number from [Explored.size] on is. *)

val detour : t -> int -> (Rat.t * int) option
(** The time that passes in a state before its first stretch, and the number of that one. It replaces the state's
    passing of time, or its rest. *)

val changes : t -> int -> int
(** In how many passings of time (or rests) predicate [k] changes, between the start (included) and the end. *)

val undecided : t -> int -> (int * string) option
(** A state in which, or after which, predicate [k] has no truth value, and why: its label is missing there. *)

val inexact : t -> int
(** How many instants between states are irrational: the times next to them are within 10^-12. *)

val count : t -> status -> int
