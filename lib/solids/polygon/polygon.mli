(** Polygons with holes. *)

type t = private {
  grid : Grid.t;
  outer : int array;  (** numbers of points, counter-clockwise *)
  holes : int array list;  (** each clockwise, so that the inside is on the left of every edge *)
}

type fault =
  | Short_ring of int  (** fewer than three corners; the number of the ring, 0 for the outer one *)
  | Same_place of int * int  (** two corners *)
  | Crossing of (int * int) * (int * int)  (** two edges that meet elsewhere than at a corner of both *)
  | Outside of int  (** a hole that is not inside the outer ring, or is inside another hole *)

val make : Grid.point array -> int array list -> (t, fault) result
(** [make points rings] is the polygon with these rings, the outer one first, each in either direction. Corners
    may have straight angles. Every point is in one ring at most. Near linear time for rings of which few edges
    are side by side. *)

val edges : int array -> (int * int) list
(** The edges of a ring of points, in its order; the last one leads back to the first point. *)
