(** One run of many, with its outcome for each question. *)

open Scc_exact
open Scc_calculus
open Scc_semantics

(** What happens if several transitions are possible and none of them is drawn. *)
type free =
  | Apart  (** the run stops: questions that are open stay open, and count for the worst and for the best *)
  | Evenly  (** one of them is taken, each equally likely *)

(** What is sampled. *)
type plan = {
  semantics : Semantics.t;
  declared : State.t;
  paths : Path.t list;
  free : free;
  steps : int option;
  (** transitions at most, of which the draws and lots of one instant are one; [None]: 10 000 if no run ends at a
      time, else without a bound *)
  until : Rat.t option;  (** model time at most; the horizon of all questions ends a run as well *)
}

(** The bound that ended a run. *)
type bound =
  | Steps  (** so many transitions, as [plan.steps] counts them *)
  | Time  (** [plan.until] *)
  | Instant  (** so many transitions without time passing *)
  | Interruption

(** Where a run depends on a choice that is not drawn. *)
type choice =
  | Walkers_bounce  (** where walkers bounce that would wait if the model had [blocked wait] *)
  | Splits
  (** at a weak split that has neither a chance nor a rate, or beside one: where the model draws ties, nothing else
      is left *)
  | Elsewhere

(** The outcome of a run for one question. *)
type outcome =
  | Truth of bool
  | Number of Rat.t
  | Never  (** infinite: the run never reaches the event on which the number depends *)
  | Free of choice  (** it depends on a choice that is not drawn *)
  | Too_long of bound  (** the run was stopped before the outcome was known *)
  | No_value of string

(** The result of a run. *)
type run = {
  outcomes : outcome list;  (** of each path, in order *)
  chosen : bool;  (** a choice that is not drawn was made, uniformly *)
  interrupted : bool;  (** it ended by an interruption: an outcome that depends on its rest is [Too_long] *)
}

val run : plan -> seed:int64 -> interrupted:(unit -> bool) -> int -> run
(** Makes the run with this number, whose seed is {!Scc_simulate.Simulation.seed_of}. If [interrupted ()] is true,
    it ends before its next transition; {!Scc_system.Interruption.Interrupted} ends it at once. *)
