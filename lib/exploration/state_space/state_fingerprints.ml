(** The states of a network, searched with hash compaction. *)

include Scc_graph_search.Compacted.Make (Network_lts)
