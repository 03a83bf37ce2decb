(** Finite Markov decision processes with rational probabilities (Puterman, "Markov Decision Processes"; Baier and
    Katoen, "Principles of Model Checking", chapter 10). States are 0 .. states - 1. Each has one choice or more,
    each choice a reward (of no sign but positive, or zero: a duration, a cost) and a distribution over states, its
    branches. Choices are numbered through, state by state, and branches choice by choice, so that 10^6 states with
    some 10^7 branches are a few arrays. *)

open Scc_exact

type t

val states : t -> int
val choices : t -> int
(** Of all states together. *)

val branches : t -> int
(** Of all choices together. *)

val first_choice : t -> int -> int
(** The choices of state [s] are those from [first_choice m s] to [first_choice m (s + 1) - 1]. *)

val first_branch : t -> int -> int
(** The branches of choice [c] are those from [first_branch m c] to [first_branch m (c + 1) - 1], by increasing
    targets, each target once. *)

val target : t -> int -> int
(** Of a branch. *)

val probability : t -> int -> Rat.t
(** Of a branch: positive; those of a choice have the sum 1. *)

val reward : t -> int -> Rat.t
(** Of a choice, at least 0: what is earned, or paid, when it is taken. *)

val near : t -> float array
(** The probabilities of all branches, each as the nearest float. Not to be changed. *)

val leads_into : t -> int -> Scc_data.Bits.t -> bool
(** Whether a target of the choice is in the set. *)

val stays_in : t -> int -> Scc_data.Bits.t -> bool
(** Whether all are. *)

val some_branch : t -> int -> (int -> bool) -> bool
(** Whether a target of the choice passes the test. *)

val every_branch : t -> int -> (int -> bool) -> bool

(** {1 Building} *)

(** What is wrong with what was given. *)
type fault =
  | No_choice  (** of the state *)
  | No_such_target of int
  | Not_positive of Rat.t  (** a probability *)
  | Sum of Rat.t  (** of the probabilities of a choice: it is not 1 *)
  | Negative_reward of Rat.t

type error = { state : int; choice : int;  (** of the state, from 0 on *) fault : fault }

val describe : error -> string

type builder

val builder : unit -> builder

val add_state : builder -> int
(** The next state, which is the first, 0, or one more than the one before. The choices that are added from now on
    are of this state. *)

val add_choice : builder -> ?reward:Rat.t -> (int * Rat.t) list -> unit
(** Of the state that was added last (a bug if there is none). Targets may be states that are added later; of
    several branches to one target the probabilities are added up. Without [reward] it is 0. *)

val finish : builder -> (t, error) result
(** Everything is checked here; the first fault is told. The builder is not used any more. *)
