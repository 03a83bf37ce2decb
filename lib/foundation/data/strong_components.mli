(** Strongly connected components of a part of a graph on 0 .. size - 1, by Tarjan's algorithm: for millions of
    nodes, with arrays and a stack of its own. That of ocamlgraph keeps each node in two hash tables, which is many
    times the memory. *)

type t

val compute : size:int -> inside:(int -> bool) -> successors:(int -> int array) -> t
(** Of the nodes that are inside; successors outside are left out. Each node is asked for its successors once. *)

val of_graph : size:int -> inside:(int -> bool) -> first:Int_array.t -> targets:Int_array.t -> t
(** The same of a graph that is written down: the successors of node v begin at [first v] in [targets], and end
    where that is negative. *)

val count : t -> int

val number : t -> int -> int
(** The component of a node, -1 outside. They are numbered so that no way leads to a greater number. *)

val numbers : t -> Int_array.t
(** The {!number}s of all nodes. *)

val iter : t -> (int -> int -> unit) -> unit
(** [iter c f] calls [f k v] for each node v with its component k, by increasing components. *)
