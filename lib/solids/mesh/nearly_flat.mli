(** Groups of neighbouring faces of a convex surface that are likely to be one face, bent by rounding. The
    groups are a guess, in floats, with the same result on all machines. A caller must check that a solid with
    such faces exists. *)

open Scc_geometry

val groups : within:float -> Polyhedron.ifs -> int array
(** [groups ~within set] has, for each face of a closed surface, the least face of its group. Groups grow by
    neighbours, the flattest union first. A union is made if all its corners are within the distance of some
    plane across its normal (by Newell's method). For [n] faces about [n log n] unions are tried. *)
