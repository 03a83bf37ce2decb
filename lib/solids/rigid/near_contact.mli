(** Contact within resolution (rule Near): two solids that are apart but hardly, seen as if they touched.

    Let d be the vector of least length from A to B, not zero. The witness plane is orthogonal to d, halfway
    between the two. The contact feature of a solid is the smallest feature that holds all its vertices within
    [resolution] of the plane; if no single feature holds them, the one that is nearest to the plane, all of it.
    Features of the closures of the two contact features touch iff the relative interiors of their orthogonal
    projections to the plane intersect (reading I-3), and the contact region is the intersection of the
    projections of the two contact features. So features that touch are nowhere farther than 2 [resolution] apart
    at a point of the region.

    Two solids that touch exactly are seen as {!Scc_geometry.Contact} sees them. *)

open Scc_exact
open Scc_geometry

type t = {
  first : Placed.t;  (** A *)
  second : Placed.t;  (** B *)
  gap : Vec.t;  (** d: zero iff they touch *)
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
(** [None] when the two are farther apart than [resolution]. Two solids that interpenetrate are a bug. *)

val distance2 : Placed.t -> Placed.t -> Rat.t
(** The squared distance of two solids. *)

val within : resolution:Rat.t -> Vec.t list -> Vec.t list -> bool
(** Whether the hulls of two features are at most [resolution] apart. *)
