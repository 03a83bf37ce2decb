(** Bisimilarity by refinement of partitions.

    The signature of a state is the set of pairs of a label and a block of the present partition that it reaches. A
    block whose states have different signatures is split, until no block is. Only states that a split may have
    affected get a new signature. Of the parts of a block the largest keeps its number, so that a state changes its
    block at most log2(n) times (n states, m edges):

    - [Strong]: each edge is visited O(log n) times for each edge beside it.
    - [Branching], by the definition that ignores divergence: as [Strong], but moves after inert silent steps
      (within the block) count as moves of the state. Signatures are inductive over these steps, and no longer than
      in [Strong].
    - [Weak]: as [Strong], but steps are [tau* a tau*] and [tau*]. They are searched for when they are needed and
      never stored, so memory stays linear. Time may be O(n m), so {!Quotient.blocks} reduces by branching
      bisimilarity first, which is finer. *)

type kind = Strong | Branching | Weak

type partition = {
  count : int;  (** number of blocks *)
  block : Scc_data.Int_array.t;  (** the block of each state, from 0 *)
}

val coarsest : Effort.t -> kind -> Graph.t -> partition
(** [coarsest effort kind g] is the partition in which two states are in one block iff they are bisimilar. All
    edges count as known. For [Branching], silent steps of [g] must lead to lower numbers only
    ({!Tau_cycles.collapse}). Raises {!Effort.Exhausted}. *)
