(** A search with hash compaction that is noted while it goes on, and follows what was noted of it before.

    A note has all transitions of a state. A search takes states by their numbers, and what it does with a state
    depends on its transitions alone, those to known states among them, as each may be taken for a new one: so any
    beginning of the notes makes what the search was when the last of them was written. Faults, and states without
    transitions, are not noted but looked at again. *)

open Scc_graph_search

module Make
    (L : Lts.S)
    (_ : Lts.Exchange with type context = L.context)
    (Compact : module type of Compacted.Make (L)) : sig
  val expanding : ?block:int -> Log.t -> Compact.expanding
  (** By what was kept, and then here. [block]: {!Blocks.make}. Raises {!Journal.Unfit}. *)
end
