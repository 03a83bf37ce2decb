(** The first cycle of a part of a graph on the nodes 0 to size - 1. *)

val find :
  size:int -> inside:(int -> bool) -> (int -> (int * int) list) -> (int * (int * int) list) option
(** [find ~size ~inside arcs] is the least node inside through which a cycle leads, and a cycle from it: its
    nodes, each with the choice that leaves it. [arcs v] is the edges of a node, each with its target and its
    choice, in order. The cycle begins with the first edge of the node that is on one, and goes back by the
    fewest edges. It is [None] if there is no cycle. *)
