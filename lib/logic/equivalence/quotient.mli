(** Graphs reduced by an equivalence. *)

type kind = Refine.kind = Strong | Branching | Weak

val blocks : Effort.t -> kind -> Graph.t -> Refine.partition
(** Two states of any graph are in one block iff they are bisimilar. For [Branching] and [Weak], divergence is
    not looked at: a state that can make silent steps for ever is equivalent to one that cannot. Raises
    {!Effort.Exhausted}. *)

val make : kind -> Graph.t -> Refine.partition -> Graph.t
(** One state for each block: a graph equivalent to the given one, state by state. Inert silent steps of
    [Branching] and [Weak] are gone. *)
