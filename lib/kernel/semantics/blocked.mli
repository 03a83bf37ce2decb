(** Walkers that do not bounce (rule Blocked): those that stop where they run into something, and those that do not
    take a kick that is blocked before their next draw. *)

open Scc_calculus

val stopped : Semantics.t -> State.t -> State.t
(** [stopped c s] is [s] in which those walkers stand still that run into something, until none does; in models
    whose walkers bounce, [s] itself. A walker that may bind or be absorbed at once is left as it is. *)

val waiting : Semantics.t -> kicked:(int -> bool) -> State.t -> State.t
(** [waiting c ~kicked s] is [s] in which those processes stand still whose kicks are blocked; in models whose
    walkers take all kicks, [s] itself. [s] has the velocities that all have drawn. [kicked] is true for the indices
    of the processes that have drawn now. *)
