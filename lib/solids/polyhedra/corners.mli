(** The vertices of a bounded polyhedron, as corners at which exactly n facets meet in a space of dimension n.
    Where more facets meet, each is moved outwards, by infinitely less than the one before. So one vertex
    becomes several corners, which have the same place. *)

open Scc_exact

type t = {
  point : Rat.t array;
  tight : int list;  (** the numbers of the constraints that meet there, as many as there are dimensions *)
  determinant : Z.t;  (** the absolute value of the determinant of the normals of [tight]; positive *)
  slopes : Rat.t array -> Rat.t list;
  (** [slopes c] has the coefficients, in the order of [tight], by which the objective [c] is a sum of
      multiples of their normals *)
}

val fold : most:int -> ('a -> t -> 'a) -> 'a -> Polyhedron.t -> 'a option
(** [fold ~most f start p] folds over all corners of [p] in an order that depends on its constraints. The
    polyhedron is bounded and has the dimension of its space, which is at least 1. [None] if there are more
    than [most] corners. *)
