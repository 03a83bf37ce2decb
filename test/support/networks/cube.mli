(** The cube of Figure 4, of side 2 about the origin: vertices [a] to [h], faces [bottom], [top], [left],
    [right], [front] and [back] (the sides of least and greatest z, x and y). *)

val polyhedron : Scc_geometry.Polyhedron.t
