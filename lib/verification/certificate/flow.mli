(** The passing of time in a set of states, as relations between a state and a time. *)

open Scc_polyhedra
open Scc_state_sets

type t = {
  states : Polyhedron.t;
  (** over the variables of the zone, and the time that passes, more than 0, the last one *)
  ends : Zone.t;  (** what becomes of its states, over the same variables; behaviours as they were *)
}

val passings : Zone_parts.context -> Zone.t -> Polyhedron.t -> t list
(** [passings c z region] are, taken together, all passings of time from a region in which nothing collides.
    Their times are at most those of any delay that waits, of any next split instant, and of any collision.
    They may overlap.

    Each plane of an obstacle gives an interval of times at which the offset is inside of it. Two convex solids
    that move in straight lines have not collided up to an instant in exactly two cases. Either two of these
    intervals are disjoint up to then, or one of them is empty (E. Helly's theorem on a line). *)

val contacts : Zone_parts.context -> t -> Polyhedron.t list
(** The regions of [states] where two parts collide at the end. *)
