(** Points, segments and convex polygons of one plane, in integer coordinates of that plane: the shapes of
    features in reading I-3. *)

open Scc_exact

type point = { x : Z.t; y : Z.t }

type shape = Point of point | Segment of point * point | Polygon of point list  (** counter-clockwise *)

val hull : point list -> shape
(** The convex hull of at least one point. A polygon has only its true corners, counter-clockwise from the
    lexicographically least on. *)

val corners : shape -> point list
(** The point itself, the two ends of a segment, or the corners of a polygon in their order. *)

val meet : shape -> shape -> bool
(** [meet s t] is true if the relative interiors of both intersect. *)

val dimension : shape -> shape -> int
(** The dimension of the intersection, 0 to 2, of two shapes whose relative interiors intersect. *)

val region : normal:Vec.t -> shape * Vec.t list -> shape * Vec.t list -> Vec.t list
(** The corners of the intersection of two shapes whose relative interiors intersect (a bug otherwise for a
    segment). Each shape comes with its corners in space, in the same order. The corners of polygons are
    counter-clockwise about [normal]. A point has one corner, a segment two, and a convex polygon has its
    corners in order. *)
