(** Probabilities of rare events: runs are split where they pass levels (law {e Splitting} of the rule book). *)

open Scc_base
open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_property

(** What is estimated: the probability that a run comes to the goal. *)
type plan = {
  semantics : Semantics.t;
  declared : State.t;
  goal : Property.prop;
  horizon : Rat.t option;  (** model time at which the goal is reached at the latest *)
  levels : Property.prop list;  (** passed in this order, before the goal *)
  effort : int;  (** runs from each level *)
  steps : int;  (** transitions at most, from one level to the next *)
}

val goal : Path.t -> (Property.prop * Rat.t option) option
(** The goal and the horizon of [P ... \[eventually f\]] and [P ... \[eventually f within t\]]; [None] for all
    other questions. *)

val holds_at_start : plan -> int option
(** The index of the first level, or of the goal after all levels, that is passed at the start. *)

(** One repetition. *)
type repetition = {
  passed : int list;  (** runs that passed, from each level to the next, and last to the goal *)
  undecided : int;
  (** runs that were left: after too many transitions, at a choice that nothing draws, or where the goal has no
      truth *)
  interrupted : bool;
}

val estimate : plan -> repetition -> Rat.t
(** The product of the shares that passed. Its mean over all repetitions is the probability. *)

val repeat : plan -> seed:int64 -> interrupted:(unit -> bool) -> int -> repetition
(** Makes the repetition with this number. It depends on the plan, the seed and the number alone. *)

(** All repetitions together. *)
type summary = {
  repetitions : int;
  mean : Rat.t;
  low : Rat.t;
  high : Rat.t;  (** both are proved, with the confidence: the probability is between them *)
  assumed : Rat.t;  (** twice the greatest estimate of a repetition, or 1 *)
  likely : Rat.t;
  (** an upper end under an assumption that is not proved: no repetition has an estimate greater than [assumed] *)
  shares : (int * int) list;  (** by level, and last the goal: runs that passed, of how many *)
  left : int;  (** all runs that were left *)
}

val summary : plan -> repetition list -> confidence:Rat.t -> summary option
(** The result of whole repetitions; [None] if there are none. *)

(** {1 Levels} *)

val levels : string -> (string list, Diag.t list) result
(** The predicates of ["x(p) >= 1, 2, 3"], or of ["x(p) >= 1..3"], as texts, in order. It is an error (SC0205) if
    they are not in order or have no comparison. *)
