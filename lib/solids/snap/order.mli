(** In which order vertices and faces are placed, so that each lies on at most three earlier ones. There always is
    such an order where the faces are those of a polyhedron: vertices and faces make a planar graph with two sides,
    some element of which has at most three neighbours. How long numbers get depends on the order. *)

type t = private {
  placed : int array;  (** the elements, the first one first *)
  earlier : int array array;  (** at the same places, the earlier elements that each lies on; at most three *)
  cost : int * int;  (** estimates of the longest number and of all, in bits *)
}

val best : Incidence.t -> grid:int -> count:int -> t list
(** So many of the best that were tried (layer by layer, and by chance), the best first, when free coordinates have
    [grid] bits. Empty when there is none. *)
