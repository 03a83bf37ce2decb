(** The part of the check of a template that concerns the whole solid: E0 and E5 of the rule book, reading I-2.
*)

open Scc_exact

val faults : Ivec.t array -> int array array -> Surface.t -> Polyhedron_fault.t list
(** [faults points faces surface] is empty iff the faces bound a solid convex hull, are maximal and are
    oriented outward. These are E0 and E5 for the vertices that faces use. E1, E2 and E4 must hold, and no two
    points that faces use coincide. Time linear in the size of the surface.

    The most telling fault comes first. Separate solids and a flat set are reported alone. A set that is inside
    out is reported before the faults that it has when it is turned. *)
