(** Walkers that do not bounce (rule Blocked): those that stop where they run into something, and those that do not
    take a kick that is blocked before their next draw. *)

open Scc_calculus

val stopped : Semantics.t -> State.t -> State.t
(** [stopped c s] is [s] in which those walkers stand still that run into something, until none does; in models
    whose walkers bounce, [s] itself. A walker that may bind or be absorbed at once is left as it is. *)

val stopping : Semantics.t -> State.process array -> State.process list
(** [stopping c processes] is those of [processes] that {!stopped} gives the velocity 0 first, all at once, in
    order, if there are no others. Whether a walker stops depends on pairs alone. It stops if it is to stop by its
    meeting with one other process, and no meeting of it has a candidate. *)

val waiting : Semantics.t -> kicked:(int -> bool) -> State.t -> State.t
(** [waiting c ~kicked s] is [s] in which those processes stand still whose kicks are blocked; in models whose
    walkers take all kicks, [s] itself. [s] has the velocities that all have drawn. [kicked] is true for the
    indices of the processes that have drawn now. *)

(** How two processes are to each other on the straight paths of one step. *)
type together = {
  blocks : bool;  (** they run together: a kick of either is blocked (rule Blocked, (a) and (b)) *)
  sweeps : bool;  (** the interiors of their sweeps meet (rule Blocked, (c)) *)
  undisturbed : bool;  (** they do not collide before the end of the step, nor make a bond, nor absorb, at its
                           end *)
}

val together : Semantics.t -> State.process -> State.process -> together
(** [together c p q] is this for two processes with the velocities that they have drawn, at least one of which is
    steered. It does not depend on other processes. Two that overlap are disturbed. *)
