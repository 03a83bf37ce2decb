(** Which probabilities of "stay until goal" are 0 and which are 1, by the graph alone: whatever the probabilities
    of the branches, as long as they are positive (Baier and Katoen, sections 10.1.1 and 10.6.1; de Alfaro, "Formal
    Verification of Probabilistic Systems", 1997). Least and greatest are over all schedulers.

    A run satisfies it when it comes to a state of goal, and all states before are of stay. What comes after a
    state of goal does not matter. All of these take time proportional to the MDP, but {!one_max}, which takes that
    for each of its rounds, which are few as a rule. Nothing here is recursive. *)

open Scc_data

type t
(** A question. *)

val until : Backwards.t -> stay:(int -> bool) -> goal:(int -> bool) -> t
val mdp : t -> Mdp.t
val backwards : t -> Backwards.t
val goal : t -> int -> bool

val on_the_way : t -> int -> bool
(** Of stay, and not of goal: where it is open what comes, and choices matter. *)

val zero_max : t -> Bits.t
(** The states from which the greatest probability is 0. *)

val zero_min : t -> Bits.t
(** The states from which the least probability is 0. *)

val one_max : t -> Bits.t
(** The states from which the greatest probability is 1. *)

val one_min : t -> Bits.t
(** The states from which the least probability is 1. *)

(** {1 Choices that attain them} *)

type directed = {
  set : Bits.t;
  choice : Int_array.t;  (** of each state, numbered through; -1 where none is told *)
}

val surely : t -> directed
(** {!one_max}, and for its states on the way choices with which goal is reached with probability 1: all targets
    are in the set, and one of them is nearer to goal than the state. *)

val avoiding : t -> directed
(** {!zero_min}, and for its states on the way choices of which all targets are in the set: with them goal is never
    reached. *)

val towards : t -> into:(int -> bool) -> directed
(** The states from which some scheduler leads, through states on the way, into a set with positive probability;
    the states of the set are among them. For the others on the way a choice that has a target nearer to it. *)
