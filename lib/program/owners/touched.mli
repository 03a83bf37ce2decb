(** The states of an owner that have come in a round, or have become earlier, where states are taken in the order
    of time. *)

open Scc_exact

type t = {
  id : int;
  time : Rat.t;  (** the earliest at which it is known to be reached, at the end of the round *)
  first : Clock.first option;  (** of a new state, the transition by which it was found first *)
  before : int;  (** the turn of the state before, on the earliest way *)
  place : int;  (** among what is found with that state *)
}

val all : Part.t -> Clock.t -> t array
(** The states of the round that ends, in the order in which a single search would find them. The round of the
    clock is closed. The goals of those that have become earlier are among the next {!Part.hits}. *)

val is_new : t -> bool
(** It has come in this round. *)

val place_after : int
(** The place of what holds after a state: behind all states that are found with it. *)
