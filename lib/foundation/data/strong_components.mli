(** Strongly connected components of a part of a graph on the nodes 0 to size - 1, by Tarjan's algorithm.

    It serves graphs of millions of nodes, with arrays and a stack of its own: ocamlgraph keeps each node in two
    hash tables, which takes many times the memory. *)

type t

val compute : size:int -> inside:(int -> bool) -> successors:(int -> int array) -> t
(** [compute ~size ~inside ~successors] is the components of the nodes that pass [inside]. Edges to other nodes are
    left out. [successors] is called once for each node that is inside. *)

val of_graph : size:int -> inside:(int -> bool) -> first:Int_array.t -> targets:Int_array.t -> t
(** [of_graph] is {!compute} for a graph stored in arrays. The successors of node v begin at index [first v] of
    [targets], and end before the next negative entry. *)

val count : t -> int
(** [count c] is the number of components. *)

val number : t -> int -> int
(** [number c v] is the component of node [v], from 0 on; -1 for a node outside. Components are numbered in a
    reverse topological order: no path leads to a greater number. *)

val numbers : t -> Int_array.t
(** [numbers c] is {!number} for all nodes. It is the table of [c] itself, and must not be changed. *)

val iter : t -> (int -> int -> unit) -> unit
(** [iter c f] calls [f k v] for each node v with its component k, by increasing components. *)
