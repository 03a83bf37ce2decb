(** Spheres, cylinders and cones, and the polyhedra that stand for them.

    A polyhedron P is inscribed in a ball B, all its vertices on the sphere, or circumscribed about it. Both are
    convex and hold the centre, so that their Hausdorff distance is the greatest difference of their support
    functions over unit vectors. For P within B that is r - i, where i is the distance of the nearest face plane
    from the centre (the support function of P is at least i, and is i towards that face). For the polyhedron s
    P about it, where s i >= r, it is s r - r, what the vertices are beyond the sphere. A cylinder is the
    product of a disc and a segment, and the prism that of a polygon and the same segment: their distance is
    that of disc and polygon, which is found in the same way. A cone is the hull of a disc and its apex, and the
    pyramid that of a polygon and the same apex: their distance is at most that of disc and polygon. All lengths
    are proportional to the radius, and so [d] is a fraction of it. *)

open Scc_exact
open Scc_geometry

type side = Inscribed | Circumscribed

type t = {
  corners : int;  (** around the axis *)
  factor : Rat.t;  (** of the radius: 1 for what is inscribed, else a little more *)
  distance : Rat.t;
  (** from the curved solid of radius 1 at most, for a sphere and a cylinder; of a sphere or cylinder that is
      circumscribed, exactly *)
}

val least : Rat.t
(** 1/100: a smaller distance would take more faces than are of use. *)

val disc : side -> Rat.t -> t
(** The polygon with the fewest corners, a multiple of four, that is at most [d] from the disc of radius 1;
    [least <= d < 1]. *)

val sphere : side -> Rat.t -> t
(** The same of the ball of radius 1, and the polyhedra of {!ball}. *)

val ball : int -> Polyhedron.ifs
(** The polyhedron inscribed in the ball of radius 1 whose vertices are the poles and, on the parallels at the
    multiples of a full turn by that number, those of the meridians at the same multiples. Its vertices are
    [south], [north] and [v1_1], …, by parallel from the south and meridian; its faces [f1_1], …, by zone and
    meridian. *)
