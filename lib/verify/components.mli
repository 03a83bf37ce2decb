(** Strongly connected components of a graph on the numbers below [size] (Tarjan's algorithm with a stack
    of its own: depth costs heap, not stack). *)

type t = {
  number : int array;  (** of the component of each node; -1 for nodes out of reach of the roots *)
  count : int;  (** numbers are in reverse topological order: no arc leads to a greater one *)
}

val compute : size:int -> roots:int list -> successors:(int -> int list) -> t

val members : t -> int list array
(** The nodes of each component, increasing. *)

val path :
  successors:(int -> (int * 'step) list) -> from:int -> goal:(int -> bool) -> (int * 'step) list option
(** A shortest path (breadth-first, in the order of the successors) from a node to one that satisfies the
    goal: each node that it leaves with the step taken there. Empty when [from] is a goal. *)
