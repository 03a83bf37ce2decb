(** A decision if two sets of points that spread as they move never have a point in common (rule Drift).

    A set moves with a velocity u. Each of its points has some velocity that may change, and that differs from u
    by at most the root of [spread2]. So at a time t the set is within its present convex hull, moved by t u and
    grown by a ball of radius t root [spread2]. Two such sets recede from each other iff some plane separates
    these regions at all times. This does not depend on the axes of the world. *)

open Scc_exact

type body = private {
  corners : Vec.t array;  (** relative to its place; one at least *)
  low : Vec.t;
  high : Vec.t;  (** the corners of the least box around them, relative to its place *)
}

val body : Vec.t array -> body
(** The body with these corners, relative to its place. There must be at least one. *)

type t = {
  bodies : (Vec.t * body) list;  (** bodies with their places in the world; one at least *)
  velocity : Vec.t;
  spread2 : Rat.t;
}

val exceeds : Rat.t -> Rat.t -> Rat.t -> bool
(** [exceeds d2 a b], for d2, a, b >= 0, is true if root d2 > root a + root b. *)

val range : (Vec.t * body) list -> Vec.t -> Rat.t * Rat.t
(** [range bodies n] is the least and the greatest n.p over the corners p of [bodies], in the world. *)

val for_ever : margin:Rat.t -> t -> t -> bool
(** [for_ever ~margin one two] is true if the sets recede from each other for ever along some direction n. Let w
    be the velocity of the second set less that of the first, and a and b the two [spread2]. Then n satisfies
    these conditions:
    - n.d > 0 for each difference d of a corner of the second set and a corner of the first;
    - n.d > 0 also for all points d within a cube of half the width [margin] about such a difference;
    - n.w > |n| (root a + root b).

    If it is true, it stays true for all parts of the sets. That is: for any points that are within the regions
    above at any later time, with any velocities that they may have there. *)
