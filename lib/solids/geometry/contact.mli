(** The contact of two touching solids: its region, and the features that touch (readings I-3 and I-4,
    Definition 4.5). *)

open Scc_exact

type pair = {
  first : Feature.t;  (** of A *)
  second : Feature.t;  (** of B *)
  dimension : int;  (** of the intersection of the two: 0, 1 or 2 *)
}

val region : Obstacle.t -> Vec.t -> Vec.t list
(** [region o r] are the corners of the intersection of A and B, relative to the reference point of A, for
    touching bodies at offset [r]. A point has one corner, a segment two, and a convex polygon has its corners
    in order. *)

val touching : Obstacle.t -> Vec.t -> pair list
(** Rule Touching: every pair of features whose relative interiors intersect, for touching bodies at an offset.
    Sorted. *)

val highest : Obstacle.t -> Vec.t -> pair
(** Rule Highest: the one pair of features whose relative interiors both contain the whole relative interior of
    the contact region. *)

(** {1 Of flat features} *)

val pairs : (Feature.t * Flat.shape) list -> (Feature.t * Flat.shape) list -> pair list
(** All pairs of a feature of A and one of B whose relative interiors intersect. The shapes of the features are
    in one plane. Sorted. *)
