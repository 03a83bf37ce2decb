(** The first time of contact of two convex solids that move and turn over a step (rule Turn), rounded down to
    a grid of instants. Exact: what floats cannot prove is computed by exact arithmetic. So the answer is a
    function of the exact data alone. *)

open Scc_exact
open Scc_geometry

val speed_bound : Motion.t -> Motion.t -> Rat.t
(** A bound on the speed of any point of one of the two as seen from any point of the other: |v_B - v_A| +
    |spin_A| reach_A + |spin_B| reach_B. The reach of a solid is at least the distance of each of its points
    from the centre that it turns about. Each square root and the sum are rounded up to ten bits, so that the
    number is short. It is constant while the two move on, and symmetric in the two. *)

val grid : Motion.t -> Motion.t -> resolution:Rat.t -> int
(** [grid a b ~resolution] is the least K >= 0 with {!speed_bound} 2^-K <= resolution, for a resolution > 0. In
    a time of 2^-K no gap between the two changes by more than the resolution. *)

type outcome =
  | Never  (** the interiors are disjoint throughout 0 <= t <= span *)
  | Inside  (** the interiors meet now *)
  | At of Rat.t
  (** floor((t* + phase) 2^grid) / 2^grid - phase, or 0 if that is less. Here t*, with 0 <= t* < span, is the
      last instant such that the interiors are disjoint from 0 to t*. Grazes and sliding are no contact. *)

val first_time_of_contact :
  ?obstacle:Obstacle.t -> ?phase:Rat.t -> Motion.t -> Motion.t -> span:Rat.t -> grid:int -> outcome
(** The first contact of two motions within a span >= 0, on a grid >= 0. The phase, 0 if it is not given, is
    the time since the grid began to count, and not negative. [obstacle] is the obstacle of the two solids as
    they are in the motions, in this order. It saves time when neither turns nor has turned, and never changes
    the answer. *)

val next_instant : grid:int -> phase:Rat.t -> Rat.t -> Rat.t
(** [next_instant ~grid ~phase t] is the first instant of the grid after [t]. *)
