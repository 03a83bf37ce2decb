(** How time passes in a set of states, as relations between a state and a time. *)

open Scc_polyhedra
open Scc_symbolic

type t = {
  states : Polyhedron.t;
  (** over the variables of the zone, and the time that passes, more than 0, the last one *)
  ends : Zone.t;  (** what becomes of its states, over the same variables; behaviours as they were *)
}

val delays : Arrangement.context -> Zone.t -> Linear.t list
(** What is left of each delay that waits. *)

val clocks : Arrangement.context -> Zone.t -> Linear.t list
(** What is left until each next split instant, where there is a grid of them. *)

val passings : Arrangement.context -> Zone.t -> Polyhedron.t -> t list
(** Together all passings of time from a region of the zone in which nothing collides, by times that are not
    longer than any delay that waits, any split instant that is to come, and any way to a collision: they may
    overlap. Two convex solids that move in straight lines have not collided up to an instant iff, of the times at
    which one has got in by each plane and not out by it, two planes have none in common, or one has none (E.
    Helly's theorem on a line). *)

val contacts : Arrangement.context -> t -> Polyhedron.t list
(** Where two parts collide at the end. *)
