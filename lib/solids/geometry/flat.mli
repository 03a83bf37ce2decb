(** Points, segments and convex polygons of one plane, in integer coordinates of that plane: what reading I-3 asks
    of features. *)

open Scc_exact

type point = { x : Z.t; y : Z.t }

type shape = Point of point | Segment of point * point | Polygon of point list  (** counter-clockwise *)

val hull : point list -> shape
(** The convex hull of some points (at least one); a polygon has its true corners only, from the lexicographically
    least on. *)

val corners : shape -> point list

val meet : shape -> shape -> bool
(** Whether the relative interiors intersect. *)

val dimension : shape -> shape -> int
(** Of the intersection, for shapes whose relative interiors intersect. *)

val region : normal:Vec.t -> shape * Vec.t list -> shape * Vec.t list -> Vec.t list
(** The corners of the intersection of two shapes whose relative interiors intersect (a bug otherwise for a
    segment). Each shape comes with its corners in space, in the same order; those of polygons are
    counter-clockwise about [normal]. One corner for a point, two for a segment, the corners of a convex polygon
    in order otherwise. *)
