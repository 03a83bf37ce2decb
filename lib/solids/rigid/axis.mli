(** The axes that can separate two turning convex solids A and B (rule Turn), and the conditions under which
    they do, exactly: the theorem of separating axes.

    The interiors of A and B are disjoint at an instant iff a plane of one of three kinds separates them. The
    plane of a face of A has B on its outer side; or the plane of a face of B has A there. Or the plane through
    an edge of A along an edge of B, not parallel to it, has A on one side and B on the other. Each axis turns
    with the solids that it is made of. All conditions are of the form g(s) >= 0 with a polynomial g of degree
    at most 5. *)

open Scc_exact

type pair = private {
  a : Motion.t;
  b : Motion.t;
  from : Rat.t;
  length : Rat.t;  (** > 0; the variable is s = (t - from)/length, so that s is from 0 to 1 *)
  turn_a : Z.t array array;
  turn_b : Z.t array array;
  (** w, x, y, z of a quaternion proportional to the rotation of the solid, each a polynomial (coefficients
      from the constant up) *)
  points_a : Ivec.t array;
  points_b : Ivec.t array;  (** the vertices about the centre of the motion, in the frame of the solid *)
  apart : Ivec.t * Ivec.t;  (** from the centre of A to that of B: [fst apart + s snd apart] *)
  denominator : Z.t;  (** the denominator of the points and of [apart]; positive *)
  turning : Z.t array array array;  (** the other polynomials, as the code defines them *)
  toward_a : Z.t array array;
  toward_b : Z.t array array;
  scale : Z.t array;
  crossing : Z.t array array array Lazy.t;
}

val pair : Motion.t -> Motion.t -> from:Rat.t -> until:Rat.t -> pair
(** [pair a b ~from ~until] are two motions over the times from [from] to [until], where from < until. *)

type t =
  | Face_a of int
  | Face_b of int
  | Edges of { a : int; b : int; positive : bool }
  (** the normal from A to B is the cross product of the edges, in this order, or its opposite *)

val equal : t -> t -> bool
(** [equal x y] is true if both are the same axis of a pair. *)

val conditions : pair -> t -> int
(** [conditions p axis] is the number of conditions of the axis. *)

val condition : pair -> t -> int -> Polynomial.t
(** [condition p axis i] is condition [i], a polynomial that must be >= 0. Apply the function to [p] and [axis]
    once for all [i]. For a face: vertex [i] of the other solid is on the outer side. For edges, condition 0:
    the solids are on different sides, if conditions 1 to 4 hold. These say that the direction lies between the
    normals at the edge of A, left and right, and at the edge of B. *)

val parallel : pair -> t -> bool
(** [parallel p axis] is true if the axis is that of edges that are parallel at all times. Such an axis never
    separates, whatever the conditions say. Edges that are parallel only at some instants are no axis at those
    instants. But if the conditions hold on one side of such an instant, some other axis separates at it, by
    continuity. *)
