(** Bisimilarity by refinement of partitions.

    The signature of a state says which blocks of the present partition it reaches by which labels; a block whose
    states differ in that is split, until none is. Only states that a split may have touched get a new signature,
    and of the parts of a block the largest keeps its name, so that a state changes its block at most log2(n)
    times (n states, m edges):

    - [Strong]: each edge is looked at O(log n) times for each edge beside it.
    - [Branching], by the definition that does not look at divergence: the same, what can be done after inert
      silent steps (within the block) counting as the state's own. Signatures are inductive over these steps and
      no longer than in [Strong].
    - [Weak], likewise: steps are [tau* a tau*] and [tau*]. They are searched for when they are needed and never
      stored, so memory stays linear; time may be O(n m), so {!Quotient.make} reduces by branching
      bisimilarity first, which is finer. *)

type kind = Strong | Branching | Weak

type partition = {
  count : int;  (** number of blocks *)
  block : Scc_data.Int_array.t;  (** of each state, from 0 *)
}

val coarsest : Effort.t -> kind -> Graph.t -> partition
(** Two states are in one block iff they are bisimilar. Whether states are known plays no part. For [Branching]
    silent steps lead to lower numbers only ({!Tau_cycles.collapse}). Raises {!Effort.Exhausted}. *)
