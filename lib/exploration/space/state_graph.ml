(** The graph of the states of a network. *)

include Scc_explore.Explore.Make (Network_lts)
