(** Independent runs of a model, and what is observed of them at given times. *)

open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_export

type plan = {
  semantics : Semantics.t;
  declared : State.t;
  observables : Table.observable list;
  times : Rat.t array;  (** increasing, from 0 on; the run ends at the last *)
  steps : int option;  (** at most so many transitions *)
}

val times : every:Rat.t -> until:Rat.t -> Rat.t array
(** The multiples of [every] up to [until], and that itself. *)

val too_many : every:Rat.t -> until:Rat.t -> bool
(** More than {!most_times}. *)

val most_times : int

val seed_of : int64 -> int -> int64
(** [seed_of seed k], the seed of run k, from 0 on: the output number k, from 0 on, of the generator SplitMix64
    that begins with the seed. So what a run is depends on seed and number alone, and [scc trace --choose random:]
    makes the same. *)

(** Values are exact: a number, or of a predicate 1 or 0; [None]: it has none there, or the run was over. *)
type run = {
  number : int;
  values : Rat.t option array array;  (** by time, and then by observable *)
  ended : string option;  (** why it did not come to the last time *)
}

val run : plan -> seed:int64 -> int -> run
(** What is observed at a time is so after all that happens at that instant. Draws are by their probabilities, and
    what is free is chosen evenly among all transitions, as nothing tells how likely it is. *)
