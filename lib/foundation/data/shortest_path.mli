(** Shortest paths in graphs whose nodes are numbers, by breadth-first search. *)

val find :
  successors:(int -> (int * 'step) list) -> from:int -> goal:(int -> bool) -> (int * 'step) list option
(** [find ~successors ~from ~goal] is a shortest path from [from] to a node that passes [goal]; of several it is
    the first in the order of the successors. The path is a list of nodes, each with the step that leaves it; the
    goal itself is not listed. It is empty if [from] passes, and [None] if no goal can be reached. *)
