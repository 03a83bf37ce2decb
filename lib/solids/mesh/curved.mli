(** Spheres, cylinders and cones, and the polyhedra that replace them.

    A polyhedron P is inscribed in a ball B, with all its vertices on the sphere, or circumscribed about it.
    Both are convex and contain the centre. So their Hausdorff distance is the greatest difference of their
    support functions over unit vectors.

    For P within B this distance is r - i, where i is the distance of the nearest face plane from the centre.
    The support function of P is at least i, and equal to i towards that face. For the polyhedron s P about B,
    where s i >= r, the distance is s r - r: the vertices are so far beyond the sphere.

    A cylinder is the product of a disc and a segment, and the prism that of a polygon and the same segment.
    Their distance is that of disc and polygon, which is found in the same way. A cone is the hull of a disc and
    its apex, and the pyramid that of a polygon and the same apex. Their distance is at most that of disc and
    polygon.

    All lengths are proportional to the radius, so [d] is a fraction of the radius. *)

open Scc_exact
open Scc_geometry

(** On which side of the curved surface the polyhedron is. *)
type side = Inscribed | Circumscribed

(** A polyhedron or polygon for a curved solid of radius 1. *)
type t = {
  corners : int;  (** around the axis *)
  factor : Rat.t;  (** of the radius: 1 if it is inscribed, and a little more otherwise *)
  distance : Rat.t;
  (** an upper bound of the Hausdorff distance from the curved solid; exact if it is circumscribed and no cone *)
}

val least : Rat.t
(** The least distance [d]: 1/100. A smaller one would take too many faces to be of use. *)

val disc : side -> Rat.t -> t
(** [disc side d] is the polygon with the fewest corners, a multiple of four, within the Hausdorff distance [d]
    of the disc of radius 1. It needs [least <= d < 1]. *)

val sphere : side -> Rat.t -> t
(** [sphere side d] is the polyhedron of {!ball} with the fewest corners around the axis, a multiple of four,
    within the Hausdorff distance [d] of the ball of radius 1. It needs [least <= d < 1]. *)

val ball : int -> Polyhedron.ifs
(** [ball n] is a polyhedron inscribed in the ball of radius 1. Its vertices are the poles and the points where
    parallels and meridians meet, both at multiples of 1/n of a full turn.

    Its vertices are [south], [north] and [v1_1], …, by parallel from the south and by meridian. Its faces are
    [f1_1], …, by zone and meridian. *)
