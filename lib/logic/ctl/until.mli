(** The operators without a bound of time, each in time proportional to the graph. [generous] says how to take
    what is not known: nodes that were not explored satisfy what they can if [generous], and nothing otherwise. *)

(** What becomes of "f until g" on the way into the flow of each node. *)
type way = Reached | Lost | Passes

val ways : Timed_graph.t -> f:Positions.t -> g:Positions.t -> int -> way
(** Computed once for all nodes. [Lost] where there is no flow, and where one lasts for ever without g. *)

val successors : Timed_graph.t -> (int -> way) -> int -> int array
(** The targets of the edges, and those of the flow when it is passed. *)

val some : Timed_graph.index -> generous:bool -> f:Positions.t -> g:Positions.t -> Positions.t
(** E(f U g). *)

val every : Timed_graph.index -> generous:bool -> f:Positions.t -> g:Positions.t -> Positions.t
(** A(f U g), of all runs (rule Run): one that ends in a dead end, or goes round for ever, within one instant or
    not, counts against it if it has not met g. *)

val next : Timed_graph.index -> generous:bool -> Positions.t -> Positions.t
(** EX f. *)
