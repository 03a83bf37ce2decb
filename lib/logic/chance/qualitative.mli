(** The states in which the probability of "stay until goal" is 0, and those in which it is 1. The graph alone
    decides them, whatever the positive probabilities of branches are (Baier and Katoen, sections 10.1.1 and
    10.6.1; de Alfaro, "Formal Verification of Probabilistic Systems", 1997). Least and greatest are over all
    schedulers.

    A run satisfies the formula if it comes to a state of goal and all states before are states of stay. The run
    after a state of goal does not matter. All functions take time proportional to the MDP, except {!one_max} and
    {!surely}: they take that for each of their rounds, which are few as a rule. *)

open Scc_data

type t
(** An MDP with the sets stay and goal. *)

val until : Backwards.t -> stay:(int -> bool) -> goal:(int -> bool) -> t
(** [until b ~stay ~goal] is the formula "stay until goal" on the MDP of [b]. *)

val backwards : t -> Backwards.t
(** [backwards q] is the reversed branches given to {!until}. *)

val goal : t -> int -> bool
(** [goal q s] is true if state [s] is in goal. *)

val zero_max : t -> Bits.t
(** [zero_max q] is the states from which the greatest probability is 0. *)

val zero_min : t -> Bits.t
(** [zero_min q] is the states from which the least probability is 0. It is computed once. *)

val one_max : t -> Bits.t
(** [one_max q] is the states from which the greatest probability is 1. *)

val one_min : t -> Bits.t
(** [one_min q] is the states from which the least probability is 1. *)

(** {1 Choices that attain them} *)

type directed = {
  set : Bits.t;
  choice : Int_array.t;  (** a choice of each state, numbered through; -1 for a state without one *)
}

val surely : t -> directed
(** [surely q] is {!one_max}, with choices for its states on the way by which goal is reached with probability 1.
    All targets of such a choice are in the set, and one of them is nearer to goal than the state. *)

val avoiding : t -> directed
(** [avoiding q] is {!zero_min}, with choices for its states on the way by which goal is never reached. All targets
    of such a choice are in the set. *)

val towards : t -> into:(int -> bool) -> directed
(** [towards q ~into] is the states from which some scheduler leads, through states on the way, to a state that
    passes [into], with positive probability. States that pass are included, without a choice. The choice of any
    other state has a target nearer to [into]. *)
