(** Which neighbouring faces of a convex surface are meant to be one: rounding bends a face of more than three
    corners. Guessed in floats; whether a solid has such faces is for others to find out. The same on all
    machines. *)

open Scc_geometry

val groups : within:float -> Polyhedron.ifs -> int array
(** Of each face the least face of its group. Groups grow by neighbours, the flattest union first, as long as
    some plane (that of all their corners, by Newell's method) has all corners within the distance. Faces of a
    closed surface; on [n] of them some [n log n] unions are tried. *)
