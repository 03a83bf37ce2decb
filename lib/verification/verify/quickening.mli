(** Runs that repeat themselves ever faster, so that their instants converge: a proof (rule Run).

    A law that is linear in the velocity, and depends on nothing else, is invariant when all velocities, and
    the rate of time, are multiplied by one factor. So a run that comes back to its places, faster, goes round
    again, in proportionally less time. *)

open Scc_exact
open Scc_state_space

type t = {
  factor : Rat.t;  (** the factor by which each round is faster than the one before; > 1 *)
  until : Rat.t;  (** the limit of the instants, which they never reach *)
}

val find : Network_lts.context -> State_graph.t -> t option
(** The repetition at the end of the shortest path to the deepest state that a bound left unexpanded. At most
    about 200 states are considered. [None] if there is none. *)

val linear : Scc_calculus.Law.t -> bool
(** [linear law] is true if the law is linear in the velocity and depends on nothing else. An example is [(2 *
    vx, vy - vz, if vx > 0 then vz else 0)]. *)

val to_string : t -> string
(** The factor and the limit, as a clause for readers. *)
