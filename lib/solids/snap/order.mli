(** Orders in which vertices and faces are placed, such that each lies on at most three earlier ones. Such an
    order exists if the faces are those of a polyhedron. The reason: vertices and faces form a planar bipartite
    graph, and some element of such a graph has at most three neighbours. The length of numbers depends on the
    order. *)

type t = private {
  placed : int array;  (** the elements, the first one first *)
  earlier : int array array;  (** at the same places, the earlier elements that each lies on; at most three *)
  cost : int * int;  (** estimates of the longest number and of all, in bits *)
}

val best : Incidence.t -> grid:int -> count:int -> t list
(** [best incidence ~grid ~count] are the best orders that were tried, at most [count], the best first. Free
    coordinates have [grid] bits. Layers and chance generate the orders. The list is empty if no order
    exists. *)
