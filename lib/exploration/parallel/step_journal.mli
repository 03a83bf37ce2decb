(** A search with hash compaction that writes notes, and first follows the notes of an earlier run.

    A note has all transitions of a state. A search takes states by their numbers. Its actions depend on the
    transitions of a state alone, including those to known states, as any state may be mistaken for another. So
    any prefix of the notes makes the search as it was when the last of them was written. There are no notes for
    faults and for states without transitions; these are expanded again. *)

open Scc_graph_search

module Make
    (L : Lts.S)
    (_ : Lts.Exchange with type context = L.context)
    (Compact : module type of Compacted.Make (L)) : sig
  val expanding : ?block:int -> Log.t -> Compact.expanding
  (** [expanding ~block log] follows the notes of [log], and then finds transitions in this process and writes
      notes. [block] is the [full] of {!Blocks.make}. Raises {!Journal.Unfit}. *)
end
