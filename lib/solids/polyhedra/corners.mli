(** The vertices of a bounded polyhedron, as corners at which just as many of its facets meet as there are
    dimensions: where more meet, all are moved outwards a little, each by infinitely less than the one before,
    which makes several corners of one vertex, all at its place. *)

open Scc_exact

type t = {
  point : Rat.t array;
  tight : int list;  (** the numbers of the constraints that meet there, as many as there are dimensions *)
  determinant : Z.t;  (** the size of that of their normals; positive *)
  slopes : Rat.t array -> Rat.t list;
  (** of an objective: by what positive or negative multiples of the normals of [tight] it is their sum, in this
      order *)
}

val fold : most:int -> ('a -> t -> 'a) -> 'a -> Polyhedron.t -> 'a option
(** Over all corners of a polyhedron that is bounded and of the dimension of its space, which is 1 at least, in an
    order that depends on its constraints; [None] if there are more than [most]. *)
