(** The states of a network, searched with hash compaction. *)

include Scc_explore.Compacted.Make (Network_lts)
