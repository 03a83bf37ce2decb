(** The part of the check of a template that is about the whole: E0 and E5 of the rule book, reading I-2. *)

open Scc_exact

val faults : Ivec.t array -> int array array -> Surface.t -> Polyhedron_fault.t list
(** [faults points faces surface], when E1, E2 and E4 hold and no two points that faces use coincide: empty
    iff the faces bound a solid convex hull, are maximal and are oriented outward (E0 and E5 hold for the
    vertices that are used). Time linear in the size of the surface.

    The most telling fault comes first: separate solids alone; a flat set alone; a set that is inside out,
    then what is wrong with it when it is turned. *)
