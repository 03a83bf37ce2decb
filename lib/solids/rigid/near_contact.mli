(** Contact within resolution (rule Near): two solids with a small gap are treated as if they touched.

    Let d be the vector of least length from A to B, not zero. The witness plane is orthogonal to d, halfway
    between the two. The contact feature of a solid is the smallest feature that contains all its vertices
    within [resolution] of the plane. If no single feature contains them, it is the feature of all vertices
    that are nearest to the plane. Features of the closures of the two contact features touch iff the relative
    interiors of their orthogonal projections to the plane intersect (reading I-3). The contact region is the
    intersection of the projections of the two contact features. So features that touch are at most 2
    [resolution] apart at a point of the region.

    Two solids that touch exactly have the contact of {!Scc_geometry.Contact}. *)

open Scc_exact
open Scc_geometry

type t = {
  first : Placed.t;  (** A *)
  second : Placed.t;  (** B *)
  gap : Vec.t;  (** d, in the world: zero iff they touch *)
  normals : Ivec.t list;
  (** primitive, from A to B: that of the witness plane, or all extreme directions that separate two solids that
      touch *)
  corners : Vec.t list;
  (** of the region, in the world: one for a point, two for a segment, the corners of a convex polygon in order
      otherwise *)
  pairs : Contact.pair list;  (** the features that touch, sorted *)
  highest : Contact.pair;  (** whose relative interiors hold that of the region *)
  plane : Ivec.t * Rat.t;  (** n and h: the plane n.x = h, n primitive and from A to B *)
}

val find : resolution:Rat.t -> Placed.t -> Placed.t -> t option
(** [find ~resolution a b] is the contact of [a] and [b]; [None] if they are farther apart than [resolution].
    Two solids that interpenetrate are a bug. *)

val distance2 : Placed.t -> Placed.t -> Rat.t
(** The squared distance of two solids; 0 if they meet. *)

val within : resolution:Rat.t -> Vec.t list -> Vec.t list -> bool
(** [within ~resolution p q] is true if the hulls of two features, given by their corners, are at most
    [resolution] apart. *)
