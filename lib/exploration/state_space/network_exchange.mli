(** Processes, labels and the other things that the numbers of {!Network_lts} stand for, as bytes
    ({!Scc_codec}). *)

include Scc_graph_search.Lts.Exchange with type context = Network_lts.context
