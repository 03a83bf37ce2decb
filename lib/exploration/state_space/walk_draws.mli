(** The joint draws of walkers that wait where they are blocked (rules Blocked and JoinedDraws). *)

open Scc_exact

val most_walkers : int
(** The greatest number of walkers of which {!outcomes} finds the joint draws. *)

val outcomes :
  Walks.t -> int array -> representative:(int array -> int array) -> Joint_draws.outcome list option
(** [outcomes w tuple ~representative] is the joint distribution of all draws in a state in which all walkers
    wait to draw, as states in which the step begins, each once. The result is [None] where other processes move,
    a law cannot be evaluated, or outcomes are more than {!Joint_draws.most}. *)

val towards : Walks.t -> int array -> (int array -> bool) -> (int * Vec.t) list option
(** [towards w tuple test] is the slots of the walkers and the velocities that they draw from [tuple], so that the
    state after it passes the test; [None] if none does, or where {!outcomes} is [None]. *)
