(** States that reach each other by silent steps: they are equivalent under every relation for which silent
    steps are hard to see, and without them the silent steps make no cycle. *)

val collapse : Graph.t -> Graph.t * Scc_data.Int_array.t
(** One state for each component of the silent steps, without silent loops, and the new number of each old state. A
    silent step then leads to a lower number. *)
