(** Strongly connected components of a part of a graph on 0 .. size - 1 (Tarjan's algorithm with a stack of its
    own, in arrays: for millions of nodes). *)

type t

val compute : size:int -> inside:(int -> bool) -> successors:(int -> int array) -> t
(** Of the nodes that are inside; successors outside are left out. *)

val count : t -> int

val number : t -> int -> int
(** The component of a node, -1 outside. They are numbered so that no way leads to a greater number. *)

val iter : t -> (int -> int -> unit) -> unit
(** [iter c f] calls [f k v] for each node v with its component k, by increasing components. *)

val path :
  successors:(int -> (int * 'step) list) -> from:int -> goal:(int -> bool) -> (int * 'step) list option
(** A shortest path (breadth-first, in the order of the successors) from a node to one that satisfies the
    goal: each node that it leaves with the step taken there. Empty when [from] is a goal. *)
