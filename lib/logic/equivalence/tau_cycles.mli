(** Cycles of silent steps. States that reach each other by silent steps are equivalent under every relation with
    silent steps. *)

val collapse : Graph.t -> Graph.t * Scc_data.Int_array.t
(** [collapse g] is the graph with one state for each strong component of the silent steps, without silent loops,
    and the new number of each old state. In the graph each silent step leads to a lower number. *)
