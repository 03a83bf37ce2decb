(** The contact of two touching solids: its region, and which features touch (readings I-3 and I-4,
    Definition 4.5). *)

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
(** Rule Touching: every touching pair of features, those whose relative interiors intersect. Sorted. *)

val highest : Obstacle.t -> Vec.t -> pair
(** Rule Highest: the one pair that has the whole relative interior of the contact region in the relative
    interiors of both its features. *)

(** {1 Of flat features} *)

val pairs : (Feature.t * Flat.shape) list -> (Feature.t * Flat.shape) list -> pair list
(** All pairs of a feature of A and one of B whose relative interiors intersect, given as shapes of one plane.
    Sorted. *)
