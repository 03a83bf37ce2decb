(** States that reach each other by silent steps: they are equivalent under every relation for which silent
    steps are hard to see, and without them the silent steps make no cycle. *)

val components : Graph.t -> Ints.t * int
(** The number of each state's component, and how many there are. A silent step between components leads to a
    lower number (Tarjan's algorithm, without recursion; linear time). *)

val collapse : Graph.t -> Graph.t * Ints.t
(** One state for each component, without silent loops, and the new number of each old state. *)
