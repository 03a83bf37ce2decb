(** The first time of contact of two convex solids that move and turn over a step (rule Turn), rounded down to a
    grid of instants. Exact: floats only prove, and what they cannot prove is left to exact arithmetic, so that the
    answer is a function of the exact data alone. *)

open Scc_exact
open Scc_geometry

val speed_bound : Motion.t -> Motion.t -> Rat.t
(** A number that the speed of any point of one of the two as seen from any point of the other never exceeds:
    |v_B - v_A| + |spin_A| reach_A + |spin_B| reach_B, where the reach of a solid is at least the distance of
    each of its points from the centre that it turns about. Each square root and the sum are rounded up to ten
    bits, so that the number is short. It does not change while the two move on, nor when they are swapped. *)

val grid : Motion.t -> Motion.t -> resolution:Rat.t -> int
(** The least K >= 0 with {!speed_bound} 2^-K <= resolution, for a resolution > 0: in 2^-K no gap between the two
    changes by more than the resolution. *)

type outcome =
  | Never  (** the interiors are disjoint throughout 0 <= t <= span *)
  | Inside  (** the interiors meet now *)
  | At of Rat.t
  (** floor((t* + phase) 2^grid) / 2^grid - phase, or 0 if that is less, where t* in [0, span) is the last
      instant such that the interiors are disjoint on [0, t*]: grazes and sliding are passed over *)

val first_time_of_contact :
  ?obstacle:Obstacle.t -> ?phase:Rat.t -> Motion.t -> Motion.t -> span:Rat.t -> grid:int -> outcome
(** For a span >= 0 and a grid >= 0; the phase, 0 if it is not given, is the time since the grid began to
    count, and not negative. [obstacle] is that of the two solids as they are in the motions, in this order: it
    saves time when neither turns nor has turned, and does not change the answer. *)

val next_instant : grid:int -> phase:Rat.t -> Rat.t -> Rat.t
(** The first instant of the grid after a time. *)
