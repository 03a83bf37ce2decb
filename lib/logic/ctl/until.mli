(** The operators without a bound of time, each in time proportional to the graph. [generous] decides for nodes
    that were not explored: with [true] they satisfy an operator if they can, and with [false] they do not. *)

(** The result of "f until g" along the flow of a node: g is met, or f fails, or the end is reached. *)
type way = Reached | Lost | Passes

val ways : Timed_graph.t -> f:Positions.t -> g:Positions.t -> int -> way
(** [ways g ~f ~g] is the result for each node, computed once for all nodes. It is [Lost] for a node without a
    flow, and for a flow that lasts for ever without g. *)

val successors : Timed_graph.t -> (int -> way) -> int -> int array
(** [successors g way s] is the targets of the edges of node [s], and those of its flow if [way s] is [Passes]. *)

val some : Timed_graph.index -> generous:bool -> f:Positions.t -> g:Positions.t -> Positions.t
(** [some index ~generous ~f ~g] is the positions of E(f U g). *)

val every : Timed_graph.index -> generous:bool -> f:Positions.t -> g:Positions.t -> Positions.t
(** [every index ~generous ~f ~g] is the positions of A(f U g), over all runs (rule Run). A run that ends in a dead
    end, or repeats a cycle for ever, within one instant or not, counts against it if it has not met g. *)

val next : Timed_graph.index -> generous:bool -> Positions.t -> Positions.t
(** [next index ~generous f] is the positions of EX f. *)
