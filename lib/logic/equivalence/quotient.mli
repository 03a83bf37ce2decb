(** Graphs reduced by an equivalence. *)

type kind = Refine.kind = Strong | Branching | Weak

val blocks : Effort.t -> kind -> Graph.t -> Refine.partition
(** [blocks effort kind g] is the partition of the states of any graph in which two states are in one block iff
    they are bisimilar. For [Branching] and [Weak], divergence is ignored: a state that can make silent steps for
    ever may be equivalent to one that cannot. Raises {!Effort.Exhausted}. *)

val make : kind -> Graph.t -> Refine.partition -> Graph.t
(** [make kind g p] is the graph with one state for each block of [p]; each state is equivalent to those it stands
    for. For [Branching] and [Weak], silent steps within a block are dropped. *)
