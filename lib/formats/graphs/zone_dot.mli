(** Pictures of small graphs of zones, for Graphviz. *)

val write : Zone_exported.t -> positions:bool -> (string -> unit) -> unit
(** Writes the graph. Nodes show what distinguishes zones ({!State_digest}) and their constraints. With
    [positions] they also have the positions, as forms, of bodies that are not fixed. Edges show events, and
    where in the zone they happen, if not in all of it.

    An arrow from nowhere leads to the initial zones. A double border is a zone in which nothing need happen any
    more, in all of it or in the part that is given. A dotted border is a zone that is halted for a weak split,
    and a dashed one is not explored. *)
