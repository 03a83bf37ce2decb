(** Finite Markov decision processes with rational probabilities (Puterman, "Markov Decision Processes"; Baier and
    Katoen, "Principles of Model Checking", chapter 10).

    States are 0 .. states - 1. Each has one choice or more. Each choice has a reward of at least 0 (a duration, a
    cost) and a distribution over states: its branches. Choices are numbered through, state by state, and branches
    choice by choice. So 10^6 states with some 10^7 branches are a few arrays. *)

open Scc_exact

type t

val states : t -> int
(** [states m] is the number of states. *)

val choices : t -> int
(** [choices m] is the number of choices of all states together. *)

val branches : t -> int
(** [branches m] is the number of branches of all choices together. *)

val first_choice : t -> int -> int
(** The choices of state [s] are those from [first_choice m s] to [first_choice m (s + 1) - 1]. *)

val first_branch : t -> int -> int
(** The branches of choice [c] are those from [first_branch m c] to [first_branch m (c + 1) - 1], by increasing
    targets, each target once. *)

val target : t -> int -> int
(** [target m b] is the state that branch [b] leads to. *)

val probability : t -> int -> Rat.t
(** [probability m b] is the probability of branch [b]: positive. The probabilities of each choice have the sum 1.
*)

val reward : t -> int -> Rat.t
(** [reward m c] is earned, or paid, when choice [c] is taken. It is at least 0. *)

val near : t -> float array
(** [near m] is the float nearest to the probability of each branch. The array must not be changed. *)

val leads_into : t -> int -> Scc_data.Bits.t -> bool
(** [leads_into m c set] is true if some target of choice [c] is in the set. *)

val stays_in : t -> int -> Scc_data.Bits.t -> bool
(** [stays_in m c set] is true if all targets of choice [c] are in the set. *)

val every_branch : t -> int -> (int -> bool) -> bool
(** [every_branch m c test] is true if all targets of choice [c] pass the test. *)

val with_numbers : t -> probability:Rat.t array -> reward:Rat.t array -> t
(** [with_numbers m ~probability ~reward] has the graph of [m], other probabilities of its branches, and other
    rewards of its choices. These are as in any MDP, which is not checked. *)

val equal : t -> t -> bool
(** [equal a b] is true if both have the same states and choices, with equal probabilities and rewards. *)

(** {1 Building} *)

(** An error in the states and choices given to a builder. *)
type fault =
  | No_choice  (** the state has no choice *)
  | No_such_target of int  (** a branch leads to this number, which is no state *)
  | Not_positive of Rat.t  (** this probability is not positive *)
  | Sum of Rat.t  (** the probabilities of the choice have this sum, which is not 1 *)
  | Negative_reward of Rat.t  (** this reward is negative *)

type error = { state : int; choice : int;  (** among the choices of the state, from 0 on *) fault : fault }

val describe : error -> string
(** [describe e] is the error as a clause in words, such as ["state 3 has no choice"]. *)

type builder

val builder : unit -> builder
(** [builder ()] is a builder without states. *)

val add_state : builder -> int
(** [add_state b] adds a state and returns its number: 0 for the first, then one more each time. The choices that
    are added next belong to this state. *)

val add_choice : builder -> ?reward:Rat.t -> (int * Rat.t) list -> unit
(** [add_choice b ~reward branches] adds a choice to the last state (a bug if there is none). [branches] are
    targets with their probabilities. Targets may be states that are added later. Probabilities of several branches
    to one target are added up. [reward] is 0 by default. *)

val finish : builder -> (t, error) result
(** [finish b] is the MDP, or the first error in it: all checks are made here. The builder must not be used again.
*)
