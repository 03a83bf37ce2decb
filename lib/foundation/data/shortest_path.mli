(** Breadth-first search of a graph of numbers. *)

val find :
  successors:(int -> (int * 'step) list) -> from:int -> goal:(int -> bool) -> (int * 'step) list option
(** A shortest path, in the order of the successors, from a node to one that satisfies the goal: each node that it
    leaves with the step taken there. Empty when [from] is a goal. *)
