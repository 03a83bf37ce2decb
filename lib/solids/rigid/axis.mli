(** The axes that can separate two turning convex solids A and B (rule Turn), and the conditions under which
    they do, exactly: the theorem of separating axes.

    The interiors of A and B are disjoint at an instant iff the plane of a face of A has B on its outer side,
    or that of a face of B has A there, or the plane through an edge of A along an edge of B, not parallel to
    it, has A on one side and B on the other. Each axis turns with the solids that it is made of. All
    conditions are of the form g(s) >= 0 with a polynomial g of degree at most 5. *)

open Scc_exact

type pair = private {
  a : Motion.t;
  b : Motion.t;
  from : Rat.t;
  length : Rat.t;  (** > 0; the variable is s = (t - from)/length, so that s is from 0 to 1 *)
  turn_a : Z.t array array;
  turn_b : Z.t array array;
  (** w, x, y, z of a quaternion in proportion to the rotation of the solid, each a polynomial (from the
      constant up) *)
  points_a : Ivec.t array;
  points_b : Ivec.t array;  (** the vertices about the centre of the motion, in the frame of the solid *)
  apart : Ivec.t * Ivec.t;  (** from the centre of A to that of B: [fst apart + s snd apart] *)
  denominator : Z.t;  (** positive: what the points and [apart] are over *)
  turning : Z.t array array array;  (** the other coefficients: see the code *)
  toward_a : Z.t array array;
  toward_b : Z.t array array;
  scale : Z.t array;
  crossing : Z.t array array array Lazy.t;
}

val pair : Motion.t -> Motion.t -> from:Rat.t -> until:Rat.t -> pair
(** For from < until. *)

type t =
  | Face_a of int
  | Face_b of int
  | Edges of { a : int; b : int; positive : bool }
  (** the normal from A to B is the cross product of the edges, in this order, or its opposite *)

val equal : t -> t -> bool

val conditions : pair -> t -> int
(** How many conditions there are. *)

val condition : pair -> t -> int -> Polynomial.t
(** [condition p axis i], to be applied to [p] and [axis] once. Of a face: vertex [i] of the other solid is on
    the outer side. Of edges: 0, the solids are on different sides, given that 1 to 4: the direction lies
    between the normals at the edge of A, left and right, and at the edge of B. *)

val parallel : pair -> t -> bool
(** Whether it is one of edges that are parallel at all times, which is no axis whatever the conditions say.
    Edges that are parallel now and then only are no axis at those instants; but wherever the conditions hold
    on one side of such an instant, some other axis separates at it, by continuity. *)
