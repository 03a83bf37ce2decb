(** The contact of two touching solids: its region, and which features touch (section 1.4, readings I-3 and
    I-4, Definition 4.5). *)

open Scc_exact

type pair = {
  first : Feature.t;  (** of A *)
  second : Feature.t;  (** of B *)
  dimension : int;  (** of the intersection of the two: 0, 1 or 2 *)
}

val region : Obstacle.t -> Vec.t -> Vec.t list
(** The corners of A n B about the reference point of A, for touching bodies at an offset: one for a point,
    two for a segment, the corners of a convex polygon in order otherwise. *)

val touching : Obstacle.t -> Vec.t -> pair list
(** Every touching pair of features: those whose relative interiors intersect. Sorted. *)

val highest : Obstacle.t -> Vec.t -> pair
(** The unique pair whose relative interiors contain the relative interior of the contact region. *)
