(** Whether two sets of points that spread as they move have no point in common, ever (rule Drift).

    A set moves with a velocity u, and each of its points with some velocity that differs from u by the root of
    [spread2] at most, and may change. So at a time t it is within its convex hull now, moved by t u, and a ball of
    the radius t root [spread2]. Two such sets recede from each other iff some plane parts what they may come to:
    that does not depend on the axes of the world. *)

open Scc_exact

type body = private {
  corners : Vec.t array;  (** about its place; one at least *)
  low : Vec.t;
  high : Vec.t;  (** the least box around them *)
}

val body : Vec.t array -> body

type t = {
  bodies : (Vec.t * body) list;  (** with their places; one at least *)
  velocity : Vec.t;
  spread2 : Rat.t;
}

val exceeds : Rat.t -> Rat.t -> Rat.t -> bool
(** [exceeds d2 a b], for d2, a, b >= 0: whether root d2 > root a + root b. *)

val range : (Vec.t * body) list -> Vec.t -> Rat.t * Rat.t
(** The least and the greatest n.p of the corners p. *)

val for_ever : margin:Rat.t -> t -> t -> bool
(** A direction n exists with n.d > 0 for each difference d of a corner of the second and one of the first set,
    also of those within a cube of half the width [margin] about d, and n.w > |n| (root a + root b), where w is the
    difference of the velocities, and a and b are the two [spread2]. Along it the sets are apart, and more and more
    so. If it is true of two sets it is true of what their parts come to: of any points within the balls above, at
    any time, whose velocities are among those that these may have. *)
