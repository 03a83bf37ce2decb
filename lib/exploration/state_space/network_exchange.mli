(** Processes, labels and the other components of {!Network_lts} as bytes ({!Scc_codec}), for other processes. *)

include Scc_graph_search.Lts.Exchange with type context = Network_lts.context
