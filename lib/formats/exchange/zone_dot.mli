(** Pictures of small graphs of zones, for Graphviz. *)

val write : Zone_exported.t -> positions:bool -> (string -> unit) -> unit
(** Nodes tell what matters in a zone ({!State_digest}) and its constraints, with [positions] where bodies
    that are not fixed are as well, as forms; edges what happens, and where, if that is not all of the zone. An
    arrow from nowhere leads to the zones of the start; with a double border nothing need happen any more, from
    all of the zone or from where it is told; a dotted border is a zone that is halted for a weak split, a dashed
    one is not explored. *)
