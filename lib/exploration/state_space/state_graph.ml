(** The graph of the states of a network. *)

include Scc_graph_search.Explore.Make (Network_lts)
