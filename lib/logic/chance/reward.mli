(** The least and the greatest expected sum of rewards until "stay until goal" is satisfied, over all schedulers.
    The definition is that of PRISM and Storm (Forejt, Kwiatkowska, Norman and Parker, "Automated Verification
    Techniques for Probabilistic Systems", 2011).

    A run that never satisfies the formula has an infinite sum, whatever it earns. So the least value is infinite
    if no scheduler satisfies the formula with probability 1, and the greatest if some scheduler does not. A choice
    that is taken in a state of goal earns nothing.

    For the least value, schedulers must not leave the states from which the formula can be satisfied with
    probability 1. End components in which all choices have the reward 0 are merged: staying in one costs nothing,
    and never ends. *)

val problem : Qualitative.t -> Equations.direction -> Solution.problem
(** [problem q direction] is the problem that {!solve} solves. *)

val solve : Qualitative.t -> Equations.direction -> Effort.t -> asked:Solution.asked -> Solution.t
(** [solve q direction effort ~asked] is the least or the greatest expected sums of the states [asked]. Values are
    of all kinds of {!Answer.t}. *)
