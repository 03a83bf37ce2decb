(** Questions about the runs of a network, answered while its states are explored. *)

include Scc_ctl.On_the_fly.Make (Network_lts) (State_graph)
