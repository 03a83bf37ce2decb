(** Which of several urgent transitions of a state comes first, by chance (rule Ties). *)

open Scc_exact

type deed
(** What a transition does, as far as its probability depends on it: which processes take part, and what becomes of
    them apart from the features of a bond that is made. *)

val deed : Transition.outcome -> deed
(** [deed o] is what an urgent outcome does. *)

val odds : deed list -> deed -> Rat.t option
(** [odds all] is the probability of each deed of [all], which are those of all urgent transitions of a state. Two
    transitions have deeds of their own, also if they are alike. It is [None] if there is only one. *)

(** {1 One by chance} *)

(** A source of random numbers: [below k] is an index less than [k], each as probable as the others, and
    [by_chance chances] is an index by these probabilities. *)
type source = { below : int -> int; by_chance : Rat.t list -> int }

(** What is chosen in a state where chance decides between urgent transitions, by the indices of transitions: to let
    it decide, or one of the others, weak splits. *)
type tie = {
  others : int list;
  pick : source -> int;  (** an urgent transition, with the probabilities of {!odds} *)
}

val pick : source -> int -> (int -> deed) -> int
(** [pick source n deed] is the index of one of [n] urgent transitions, with the probabilities of {!odds}. Those of
    the same processes are next to each other. How many deeds it looks at depends on how many are of the same
    processes, and not on [n]. *)
