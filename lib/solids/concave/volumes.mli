(** Whether convex parts and a surface have the same volume. *)

open Scc_geometry

val equal : Polyhedron.ifs -> Polyhedron.t list -> bool
(** [equal surface parts] compares the two volumes modulo the prime 2^61 - 1, or a greater one if that divides a
    denominator. Equal volumes are always found equal; others are, by a chance of one in 2^61. So this guards
    against faults of the program. The sum itself of thousands of parts can have millions of digits. *)
