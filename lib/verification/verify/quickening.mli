(** Runs that repeat themselves ever faster, so that their instants converge: a proof (rule Run).

    A law that is linear in the velocity, and asks for nothing else, does not tell a network from the same one with
    all velocities, and the rate of time, multiplied by one factor. So a run that comes back to where it was,
    faster, goes round again, in as many times less time. *)

open Scc_exact
open Scc_state_space

type t = {
  factor : Rat.t;  (** > 1: how many times as fast each round is *)
  until : Rat.t;  (** what the instants converge to, and never reach *)
}

val find : Network_lts.context -> State_graph.t -> t option
(** At the end of the shortest path to the deepest state that a bound left unexpanded; no more than some 200 states
    are looked at. *)

val linear : Scc_calculus.Law.t -> bool
(** Whether a law multiplies with the velocity: as [(2 * vx, vy - vz, if vx > 0 then vz else 0)]. *)

val to_string : t -> string
