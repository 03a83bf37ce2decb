(** Independent runs of a model, with the values of observables at given times. *)

open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_export

(** What is simulated. *)
type plan = {
  semantics : Semantics.t;
  declared : State.t;
  observables : Table.observable list;
  times : Rat.t array;  (** increasing, from 0 on; the run ends at the last *)
  steps : int option;  (** at most so many transitions, of which the draws and lots of one instant are one *)
}

val times : every:Rat.t -> until:Rat.t -> Rat.t array
(** The multiples of [every] from 0 up to [until], and [until] itself. *)

val too_many : every:Rat.t -> until:Rat.t -> bool
(** [too_many ~every ~until] is true if there are more than {!most_times} multiples. *)

val most_times : int
(** The greatest number of times: 1 000 000. *)

val seed_of : int64 -> int -> int64
(** [seed_of seed k] is the seed of run [k], from 0 on: output [k], from 0 on, of the generator SplitMix64 that
    starts with [seed]. So a run depends on seed and number alone, and [scc trace --choose random:] reproduces
    it. *)

(** The values of a run. They are exact; predicates are 1 or 0. [None]: the observable has no value there, or the
    run was over. *)
type run = {
  number : int;
  values : Rat.t option array array;  (** by time, and then by observable *)
  reached : int;  (** at so many of the times, the first ones, it was observed *)
  ended : string option;  (** why it ended before the last time *)
  interrupted : bool;  (** it ended by an interruption, and would have gone on *)
}

val run : plan -> seed:int64 -> interrupted:(unit -> bool) -> int -> run
(** Simulates the run with this number. The value at a time is that after all events of the instant. What
    chance decides has its probabilities (rules Draw, Lot and Ties), and is one choice. All choices of a state are
    equally probable, since nothing says how probable they are.

    If [interrupted ()] is true, the run ends before its next transition.
    {!Scc_system.Interruption.Interrupted} ends it at once. The values up to there are those of the whole run. *)
