(** The least and the greatest expected sum of rewards until "stay until goal" is satisfied, over all schedulers,
    as PRISM and Storm have it (Forejt, Kwiatkowska, Norman and Parker, "Automated Verification Techniques for
    Probabilistic Systems", 2011): a run that never satisfies it counts as infinite, whatever it earns. So the
    least one is infinite where no scheduler satisfies it with probability 1, and the greatest where some scheduler
    does not. The choice that is taken in a state of goal earns nothing.

    For the least one the schedulers are those that never leave the states from which it can be satisfied with
    probability 1, and end components are merged of which all choices have the reward 0: to stay in one would cost
    nothing, and never end. *)

val solve : Qualitative.t -> Equations.direction -> Effort.t -> asked:Solution.asked -> Solution.t
(** Values are of all kinds. *)
